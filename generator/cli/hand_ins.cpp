#include "cli/hand_ins.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "base/files.h"
#include "base/folded_name.h"
#include "base/nearest.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 1 << 20;  // of a program that was handed in
constexpr std::size_t kMostNotes = 5;           // on one hand-in

// A path without "/" at its end, by which a link would be what it leads to.
fs::path without_slash(std::string word) {
  while (word.size() > 1 && word.ends_with('/')) word.pop_back();
  return word;
}

std::string name_of(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole.filename() : whole.parent_path().filename();
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

std::optional<std::chrono::sys_seconds> changed_at(const fs::path& file) {
  struct stat status {};
  if (lstat(file.c_str(), &status) != 0) return std::nullopt;
  return std::chrono::sys_seconds(std::chrono::seconds(status.st_mtim.tv_sec));
}

// Windows ends lines with two characters, and may put a mark in front of all. A carriage return
// that stands alone stays.
std::string with_line_feeds(const std::string& text) {
  std::string lines;
  for (std::size_t i = text.starts_with("\xef\xbb\xbf") ? 3 : 0; i < text.size(); ++i) {
    if (text[i] != '\r' || i + 1 == text.size() || text[i + 1] != '\n') lines += text[i];
  }
  return lines;
}

bool is_link_on(const fs::path& folder, const fs::path& inside) {
  fs::path at = folder;
  for (const fs::path& part : inside) {
    at /= part;
    if (fs::is_symlink(fs::symlink_status(at))) return true;
  }
  return false;
}

bool is_archive(const std::string& file) {
  constexpr std::array<std::string_view, 7> ends{".zip", ".7z", ".rar", ".tar",
                                                 ".tgz", ".gz", ".xz"};
  return std::ranges::any_of(ends, [&](std::string_view end) { return file.ends_with(end); });
}

// Is `stem` the exercise's name with more words: "fall (1)", "fall - copy", "my_fall"?
bool has_words_beside(const std::string& stem, const std::string& name) {
  return stem.ends_with(name) || (stem.starts_with(name) && !is_letter(stem[name.size()]));
}

// The exercise, one of `missing`, that `path` is likely to be meant for; "" for none.
std::string meant_by(const fs::path& path, const std::vector<std::string>& missing) {
  const std::string file = lower(path.filename());
  // Some systems hide the end of a name, and put another behind it: "fall.cpp.txt".
  const std::size_t end = std::min(file.find(".cpp"), file.rfind('.'));
  const std::string stem = file.substr(0, end);
  const auto part = std::ranges::find_if(missing, [&](const std::string& name) {
    const bool is_part = file.find(".cpp") != file.npos && lower(name).ends_with(stem);
    return !stem.empty() && (is_part || has_words_beside(stem, lower(name)));
  });
  return part == missing.end() ? "" : *part;
}

// Gives those of one name names of their own, and says so.
void tell_apart(HandIns& hand_ins) {
  std::map<std::string, std::vector<std::size_t>> by_name;
  for (std::size_t i = 0; i < hand_ins.all.size(); ++i) {
    by_name[folded_name(hand_ins.all[i].student)].push_back(i);
  }
  for (const auto& [name, indices] : by_name) {
    if (indices.size() < 2) continue;
    std::string folders;
    for (const std::size_t i : indices) {
      HandIn& one = hand_ins.all[i];
      folders += (folders.empty() ? "" : ", ") + readable(one.folder.string());
      one.student = one.folder.string();
    }
    hand_ins.notes.push_back("these may be the same student, and each is graded: " + folders);
  }
}

}  // namespace

HandIns find_hand_ins(const std::vector<std::string>& words) {
  HandIns hand_ins;
  std::vector<fs::path> known;
  for (const std::string& word : words) {
    const fs::path folder = without_slash(word);
    const std::string shown = readable(folder.string());
    std::error_code fault;
    const fs::file_status status = fs::symlink_status(folder, fault);
    if (!fs::exists(status)) {
      hand_ins.notes.push_back("there is no folder " + shown);
    } else if (fs::is_symlink(status)) {
      hand_ins.all.push_back({name_of(folder), folder, "it is a link, and may lead to another's"});
    } else if (!fs::is_directory(status)) {
      hand_ins.notes.push_back(shown + " is no folder, and left out");
    } else if (fs::exists(folder / "verdicts") && fs::exists(folder / "students.csv")) {
      hand_ins.notes.push_back(shown + " has results, and is left out");
    } else if (const fs::path true_path = fs::weakly_canonical(folder, fault);
               std::ranges::count(known, true_path) > 0) {
      hand_ins.notes.push_back(shown + " is named twice, and graded once");
    } else {
      known.push_back(true_path);
      hand_ins.all.push_back({name_of(folder), folder});
    }
  }
  tell_apart(hand_ins);
  return hand_ins;
}

HandedIn read_handed_in(const HandIn& hand_in, const std::string& name) {
  if (!hand_in.fault.empty()) return {};
  const DiskFiles files(hand_in.folder);
  for (const std::string& path : {name + ".cpp", name + "/" + name + ".cpp"}) {
    if (is_link_on(hand_in.folder, path)) return {{}, "it is a link, and may lead to another's"};
    if (files.refusal(path)) return {{}, "it is no plain file"};
    if (!files.exists(path)) continue;
    std::error_code none;
    if (fs::file_size(hand_in.folder / path, none) > kMostBytes || none) {
      return {{}, "it has more than 1 MiB"};
    }
    const auto text = files.read(path);
    if (!text) return {{}, "it cannot be read"};
    if (text->find('\0') != text->npos) return {{}, "it is no text in UTF-8: save it as such"};
    if (text->find('\n') == text->npos && text->find('\r') != text->npos) {
      return {{}, "its lines end with carriage returns alone: save it with line feeds"};
    }
    return {with_line_feeds(*text), "", changed_at(hand_in.folder / path)};
  }
  return {};
}

std::vector<std::string> notes_on(const HandIn& hand_in, const std::vector<std::string>& names) {
  if (!hand_in.fault.empty()) return {};
  std::vector<std::string> notes, strays, missing;
  const DiskFiles files(hand_in.folder);
  const auto note = [&](const std::string& text, std::vector<std::string>& into) {
    if (into.size() < kMostNotes) into.push_back(readable(hand_in.student) + ": " + text);
  };
  std::ranges::copy_if(names, std::back_inserter(missing), [&](const std::string& name) {
    return !read_handed_in(hand_in, name).is_there();
  });
  const std::vector<DiskFiles::Entry> below = files.below("");
  if (below.empty()) note("the folder is empty, or cannot be read", notes);
  for (const DiskFiles::Entry& entry : below) {
    const fs::path path(entry.path);
    if (entry.is_folder) continue;
    const std::string stem = path.stem(), shown = readable(entry.path),
                      file = lower(path.filename());
    if (path == fs::path(stem) / (stem + ".cpp") && files.exists(stem + ".cpp")) {
      note(readable(stem) + ".cpp is graded, and " + shown + " is not", notes);
    }
    if (missing.empty()) continue;
    if (path.extension() == ".cpp" && std::ranges::count(names, stem) > 0) {
      if (std::ranges::count(missing, stem) == 0) continue;
      note(shown + " is not where it is looked for: " + stem + ".cpp, or " + stem + "/" + stem +
               ".cpp",
           notes);
      continue;
    }
    if (is_archive(file)) {
      note(shown + " is an archive, and not looked into: unpack it", notes);
    } else if (const std::string meant = meant_by(path, missing); !meant.empty()) {
      note(shown + " has the name of no exercise: is it " + meant + ".cpp?", notes);
    } else if (const std::size_t end = file.find(".cpp"); end != file.npos) {
      note(shown + " has the name of no exercise; " + suggest(file.substr(0, end), missing), notes);
    } else if (missing.size() == names.size()) {
      note(shown + " is no NAME.cpp of an exercise", strays);
    }
  }
  for (std::size_t i = 0; i < strays.size() && notes.size() < kMostNotes; ++i) {
    notes.push_back(strays[i]);
  }
  return notes;
}

}  // namespace mjcourse
