// An Origin says whether an entry of a store was made here, and if not, who vouches for it.
//
// A server's word is believed for as long as no keys are trusted. Once there are, what came without
// a signature before is as good as nothing, and so is what was made of it. So an entry of the disk
// says where it is from, and what is made of others is from where all of these are.
// Tested by tests/generator/base/origin_test.cpp.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace mjcourse {

class Origin {
 public:
  Origin() = default;  // made here, of nothing that came from elsewhere
  static Origin unsigned_one();
  static Origin signed_by(std::string public_key);

  bool is_made_here() const { return !unsigned_ && keys_.empty(); }
  // To what it is of comes `other`.
  void add(const Origin& other);

  // One word: "made", "unsigned", or the keys. Nothing where it is none.
  std::string text() const;
  static std::optional<Origin> read(std::string_view text);

  bool operator==(const Origin&) const = default;

 private:
  friend struct Trust;
  bool unsigned_ = false;       // in part; nobody vouches for that
  std::set<std::string> keys_;  // that have signed the rest
};

// Whom a machine believes.
struct Trust {
  bool everybody = true;
  std::set<std::string> keys = {};  // public ones; else these alone

  // Is all of it made here, or signed by one of these?
  bool vouches_for(const Origin& origin) const;
  bool believes(const Origin& origin) const { return everybody || vouches_for(origin); }
};

}  // namespace mjcourse
