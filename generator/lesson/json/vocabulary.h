// The words of a fence's JSON: which keys an object has, what may stand behind each, and what it
// means.
//
// Of each object there is one table. JsonObject reads by it. It takes from nowhere else what must
// be there, what a number may be and which keys there are. To ask for a key that the table lacks is
// a fault of the generator, and so is a key for which nothing asked. The site's schemas
// (page/json_schema.h) and what an editor is told are made of the same table. So no two of these
// can say different things.
//
// Enter at vocabulary_of("lab") (json_fences.h); the tables are in lab_vocabulary.h and its like.
#pragma once

#include <limits>
#include <span>
#include <string_view>

namespace mjcourse {

struct Vocabulary;

// What stands behind a key.
enum class KeyKind {
  text,
  markdown,    // with math
  model,       // a model's name, or MJCF, which begins with `<`
  expression,  // JavaScript that gives a value
  script,      // JavaScript; it may be a list of strings, which are its lines
  mjcf,        // in the same way
  word,        // one of the vocabulary's variants
  number,
  whole,  // a number without decimals
  boolean,
  tolerance,         // a number, or a percentage: "1%"
  point,             // three numbers
  size,              // two whole numbers
  indices,           // a list of whole numbers, counted from 0
  texts,             // a list of strings
  expressions,       // a list of strings
  overlays,          // {"frames": true}
  object,            // as Key::of says
  objects,           // a list of these
  texts_or_objects,  // a list of strings and of these
  true_or_object     // true or false, or one of these
};

// Must it be there?
enum class Need {
  none,
  there,
  filled  // and not be empty
};

// Which numbers a key takes, or how many a list has, and what a message says of it: "is a number of
// pixels: from 1 to 9".
struct Limits {
  double least = std::numeric_limits<double>::lowest(), most = std::numeric_limits<double>::max();
  std::string_view text = {};
};

inline constexpr double kAboveZero = std::numeric_limits<double>::min();

struct Key {
  std::string_view name;
  KeyKind kind;
  std::string_view meaning;  // Markdown, one line
  Need need = Need::none;
  Limits limits = {};
  const Vocabulary* of = nullptr;
};

struct Variant {
  std::string_view word;
  const Vocabulary* vocabulary;
};

struct Vocabulary {
  std::string_view name;  // as messages call the object: "slider"
  std::span<const Key> keys;
  // Where the first key's value decides what the others are. Each variant has all of its keys.
  std::span<const Variant> variants = {};
  bool open = false;  // has it other keys besides, which we leave to somebody else

  const Key* find(std::string_view key) const;
  const Vocabulary* variant(std::string_view word) const;
};

}  // namespace mjcourse
