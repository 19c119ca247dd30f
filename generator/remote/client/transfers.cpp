#include "remote/client/transfers.h"

#include <algorithm>
#include <cstdio>
#include <new>
#include <sstream>
#include <utility>

#include "remote/client/proxies.h"
#include "remote/client/settled_calls.h"

namespace mjcourse {
namespace {

// A store that is slower than this is slower than the work. In ms, s, and bytes/s.
constexpr long kConnect = 3000, kStall = 5, kSlowest = 1000, kLongest = 60;
constexpr long kConnections = 16;

// What a server may make us hold: of a blob, of another entry, and of all that is under way. The
// largest of a course have 1 MB; a film may have 100.
constexpr std::size_t kMostBlob = std::size_t{256} << 20, kMostEntry = std::size_t{64} << 20,
                      kMostAtOnce = std::size_t{512} << 20;

struct Upload {
  std::string_view all, rest = all;
};

std::size_t give(char* bytes, std::size_t size, std::size_t count, void* from) {
  auto& upload = *static_cast<Upload*>(from);
  const std::size_t given = std::min(size * count, upload.rest.size());
  std::copy_n(upload.rest.data(), given, bytes);
  upload.rest.remove_prefix(given);
  return given;
}

// A connection that was kept may turn out to be gone.
int begin_again(void* from, curl_off_t offset, int origin) {
  auto& upload = *static_cast<Upload*>(from);
  if (origin != SEEK_SET || offset < 0 || std::cmp_greater(offset, upload.all.size())) {
    return CURL_SEEKFUNC_CANTSEEK;
  }
  upload.rest = upload.all.substr(static_cast<std::size_t>(offset));
  return CURL_SEEKFUNC_OK;
}

int is_connected(void*, curl_socket_t, curlsocktype) {
  return CURL_SOCKOPT_ALREADY_CONNECTED;
}

}  // namespace

struct Transfers::Transfer {
  Transfer(Message question, std::size_t& at_once)
      : sent(std::move(question.body)), taken_at_once(at_once), upload{sent} {
    std::istringstream(question.head) >> number >> verb >> path;
    most = path.starts_with("cas/") ? kMostBlob : kMostEntry;
  }
  ~Transfer() {
    taken_at_once -= taken.size();
    curl_easy_cleanup(easy);
    curl_url_cleanup(url);
  }
  Transfer(const Transfer&) = delete;
  Transfer& operator=(const Transfer&) = delete;

  CURL* easy = curl_easy_init();
  CURLU* url = curl_url();  // which `easy` reads until its end
  // libcurl ends the transfer of which fewer bytes were taken than there are.
  static std::size_t take(char* bytes, std::size_t, std::size_t count, void* into) {
    auto& transfer = *static_cast<Transfer*>(into);
    transfer.is_too_large = transfer.taken.size() + count > transfer.most ||
                            transfer.taken_at_once + count > kMostAtOnce;
    if (transfer.is_too_large) return 0;
    transfer.taken.append(bytes, count);
    transfer.taken_at_once += count;
    return count;
  }

  std::string number, verb, path, sent, taken;
  std::size_t most;
  std::size_t& taken_at_once;  // by all of them
  bool is_too_large = false;
  Upload upload;
  char error[CURL_ERROR_SIZE] = {};
};

Transfers::Transfers(std::string_view settings, std::function<Descriptor()> connect)
    : connect_(std::move(connect)), multi_(curl_multi_init()) {
  if (multi_ == nullptr) throw std::bad_alloc();
  FrameReader each;
  each.add(settings);
  while (auto setting = each.next()) settings_[setting->head] = std::move(setting->body);
  // What is connected already, some versions of libcurl connect all the same.
  if (!settings_.at("socket").empty()) settle_calls({{SYS_connect, 0}});
  // A server that waits for our content need not say so first.
  headers_ = curl_slist_append(headers_, "Expect:");
  headers_ = curl_slist_append(headers_, "Content-Type: application/octet-stream");
  curl_multi_setopt(multi_, CURLMOPT_MAX_HOST_CONNECTIONS, kConnections);
}

Transfers::~Transfers() {
  for (const Transfer& transfer : transfers_) curl_multi_remove_handle(multi_, transfer.easy);
  curl_slist_free_all(headers_);
  curl_multi_cleanup(multi_);
}

// Instead of libcurl, which gets one that is connected.
curl_socket_t Transfers::open_socket(void* transfers, curlsocktype, curl_sockaddr*) {
  Descriptor socket = static_cast<Transfers*>(transfers)->connect_();
  return socket.is_open() ? socket.release() : CURL_SOCKET_BAD;
}

void Transfers::prepare(Transfer& transfer) {
  CURL* const easy = transfer.easy;
  if (easy == nullptr || transfer.url == nullptr) throw std::bad_alloc();
  const auto set_part = [&](CURLUPart part, const std::string& value) {
    if (!value.empty()) curl_url_set(transfer.url, part, value.c_str(), 0);
  };
  set_part(CURLUPART_URL, settings_.at("url") + "/" + transfer.path);
  set_part(CURLUPART_USER, settings_.at("user"));
  set_part(CURLUPART_PASSWORD, settings_.at("password"));
  curl_easy_setopt(easy, CURLOPT_CURLU, transfer.url);
  curl_easy_setopt(easy, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(easy, CURLOPT_HTTP_VERSION, CURL_HTTP_VERSION_2TLS);
  curl_easy_setopt(easy, CURLOPT_PIPEWAIT, 1L);
  curl_easy_setopt(easy, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(easy, CURLOPT_CONNECTTIMEOUT_MS, kConnect);
  curl_easy_setopt(easy, CURLOPT_LOW_SPEED_LIMIT, kSlowest);
  curl_easy_setopt(easy, CURLOPT_LOW_SPEED_TIME, kStall);
  curl_easy_setopt(easy, CURLOPT_TIMEOUT, kLongest);
  curl_easy_setopt(easy, CURLOPT_ERRORBUFFER, transfer.error);
  curl_easy_setopt(easy, CURLOPT_PRIVATE, &transfer);
  curl_easy_setopt(easy, CURLOPT_HTTPHEADER, headers_);
  curl_easy_setopt(easy, CURLOPT_WRITEFUNCTION, Transfer::take);
  curl_easy_setopt(easy, CURLOPT_WRITEDATA, &transfer);
  curl_easy_setopt(easy, CURLOPT_MAXFILESIZE_LARGE, static_cast<curl_off_t>(transfer.most));
  const auto set = [&](const char* name, CURLoption option) {
    const std::string& value = settings_.at(name);
    if (!value.empty()) curl_easy_setopt(easy, option, value.c_str());
  };
  const auto set_file = [&](const char* name, CURLoption option) {
    std::string& value = settings_.at(name);
    curl_blob file{value.data(), value.size(), CURL_BLOB_NOCOPY};
    if (!value.empty()) curl_easy_setopt(easy, option, &file);
  };
  set_file("certificate", CURLOPT_SSLCERT_BLOB);
  set_file("key", CURLOPT_SSLKEY_BLOB);
  set_file("authorities", CURLOPT_CAINFO_BLOB);
  set("token", CURLOPT_XOAUTH2_BEARER);
  if (!settings_.at("socket").empty()) {
    set("socket", CURLOPT_UNIX_SOCKET_PATH);
    curl_easy_setopt(easy, CURLOPT_OPENSOCKETFUNCTION, open_socket);
    curl_easy_setopt(easy, CURLOPT_OPENSOCKETDATA, this);
    curl_easy_setopt(easy, CURLOPT_SOCKOPTFUNCTION, is_connected);
  }
  if (!settings_.at("token").empty()) {
    curl_easy_setopt(easy, CURLOPT_HTTPAUTH, static_cast<long>(CURLAUTH_BEARER));
  }
  if (transfer.verb == "HEAD") curl_easy_setopt(easy, CURLOPT_NOBODY, 1L);
  if (transfer.verb != "PUT") return;
  curl_easy_setopt(easy, CURLOPT_UPLOAD, 1L);
  curl_easy_setopt(easy, CURLOPT_READFUNCTION, give);
  curl_easy_setopt(easy, CURLOPT_READDATA, &transfer.upload);
  curl_easy_setopt(easy, CURLOPT_SEEKFUNCTION, begin_again);
  curl_easy_setopt(easy, CURLOPT_SEEKDATA, &transfer.upload);
  curl_easy_setopt(easy, CURLOPT_INFILESIZE_LARGE, static_cast<curl_off_t>(transfer.sent.size()));
}

void Transfers::begin(Message question) {
  Transfer& transfer = transfers_.emplace_back(std::move(question), taken_at_once_);
  prepare(transfer);
  curl_multi_add_handle(multi_, transfer.easy);
}

bool Transfers::wait(int input) {
  curl_waitfd waited{input, CURL_WAIT_POLLIN, 0};
  int under_way = 0;
  curl_multi_perform(multi_, &under_way);
  curl_multi_poll(multi_, &waited, 1, 1000, nullptr);
  curl_multi_perform(multi_, &under_way);
  return waited.revents != 0;
}

std::string Transfers::answer_of(const Transfer& transfer, CURLcode result) const {
  if (transfer.is_too_large || result == CURLE_FILESIZE_EXCEEDED) {
    return frame_of(transfer.number + " 0", "an answer of it is larger than any entry");
  }
  if (result != CURLE_OK) {
    std::string why = proxy_fault(settings_.at("url"));  // which libcurl tells of with all it holds
    if (why.empty()) why = transfer.error[0] != '\0' ? transfer.error : curl_easy_strerror(result);
    return frame_of(transfer.number + " 0", why);
  }
  long status = 0;
  curl_easy_getinfo(transfer.easy, CURLINFO_RESPONSE_CODE, &status);
  long version = 0;
  curl_easy_getinfo(transfer.easy, CURLINFO_HTTP_VERSION, &version);
  const char* const protocol = version == CURL_HTTP_VERSION_2_0 ? " 2" : " 1";
  return frame_of(transfer.number + " " + std::to_string(status) + protocol, transfer.taken);
}

std::vector<std::string> Transfers::finished() {
  std::vector<std::string> answers;
  int more = 0;
  while (const CURLMsg* message = curl_multi_info_read(multi_, &more)) {
    if (message->msg != CURLMSG_DONE) continue;
    CURL* const easy = message->easy_handle;
    Transfer* transfer = nullptr;
    curl_easy_getinfo(easy, CURLINFO_PRIVATE, &transfer);
    answers.push_back(answer_of(*transfer, message->data.result));
    curl_multi_remove_handle(multi_, easy);
    transfers_.remove_if([&](const Transfer& one) { return &one == transfer; });
  }
  return answers;
}

}  // namespace mjcourse
