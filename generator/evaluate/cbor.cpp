#include "evaluate/cbor.h"

#include <nlohmann/json.hpp>

#include "base/utf8.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr int kMostDepth = 100;  // of lists and objects; a result has about ten

// Reads without keeping anything, and ends the reading where it goes too deep, or where a text is
// none: what writes values as JSON wants UTF-8.
class SoundCbor : public nlohmann::json_sax<json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t& text) override { return !find_invalid_utf8(text); }
  bool binary(binary_t&) override { return true; }
  bool key(string_t& text) override { return !find_invalid_utf8(text); }
  bool start_object(std::size_t) override { return ++depth_ <= kMostDepth; }
  bool start_array(std::size_t) override { return ++depth_ <= kMostDepth; }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool parse_error(std::size_t, const std::string&, const json::exception&) override {
    return false;
  }

 private:
  bool leave() {
    --depth_;
    return true;
  }

  int depth_ = 0;
};

}  // namespace

std::string to_cbor(const json& value) {
  std::string bytes;
  json::to_cbor(value, bytes);
  return bytes;
}

std::optional<json> from_cbor(std::string_view bytes) {
  SoundCbor look;
  try {
    if (!json::sax_parse(bytes, &look, json::input_format_t::cbor)) return std::nullopt;
    return json::from_cbor(bytes);
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

}  // namespace mjcourse
