#include "lesson/syntax/reference_losses.h"

#include <cmark-gfm/buffer.h>
#include <cmark-gfm/parser.h>
#include <cmark-gfm/references.h>
#include <cmark-gfm/syntax_extension.h>
#include <cmark-gfm/utf8.h>
#include <re2/re2.h>

#include <algorithm>

namespace mjcourse {
namespace {

using Defined = std::map<std::string, std::vector<std::string>>;

std::string string_of(const cmark_chunk& chunk) {
  return {reinterpret_cast<const char*>(chunk.data), static_cast<std::size_t>(chunk.len)};
}

// As cmark compares names: without regard to case, and to how many blanks are in them.
std::string compared(std::string_view name) {
  cmark_strbuf folded;
  cmark_strbuf_init(cmark_get_default_mem_allocator(), &folded, 0);
  cmark_utf8proc_case_fold(&folded, reinterpret_cast<const unsigned char*>(name.data()),
                           static_cast<bufsize_t>(name.size()));
  cmark_strbuf_trim(&folded);
  cmark_strbuf_normalize_whitespace(&folded);
  std::string text(cmark_strbuf_cstr(&folded), static_cast<std::size_t>(folded.size));
  cmark_strbuf_free(&folded);
  return text;
}

cmark_node* look(cmark_syntax_extension* self, cmark_parser* parser, cmark_node*) {
  auto& defined = *static_cast<Defined*>(cmark_syntax_extension_get_private(self));
  for (cmark_map_entry* one = parser->refmap->refs; one != nullptr; one = one->next) {
    const auto* reference = reinterpret_cast<const cmark_reference*>(one);  // begins with its entry
    defined[reinterpret_cast<const char*>(one->label)].push_back(string_of(reference->url));
  }
  for (auto& [name, addresses] : defined) std::ranges::reverse(addresses);  // the last comes first
  return nullptr;
}

// How often each name stands in brackets.
std::map<std::string, int> names_in(std::string_view text, const Defined& defined) {
  static const RE2 brackets(R"(\[((?:[^\[\]\\]|\\.)+)\])");
  std::map<std::string, int> counts;
  re2::StringPiece rest(text.data(), text.size()), name;
  while (RE2::FindAndConsume(&rest, brackets, &name)) {
    const std::string key = compared({name.data(), name.size()});
    if (defined.contains(key)) ++counts[key];
  }
  return counts;
}

// `[//]: # (a comment)`, as some write what shall not be shown.
bool is_comment(const std::string& address) {
  return address.empty() || address == "#";
}

}  // namespace

ReferenceLosses::ReferenceLosses(cmark_parser* parser)
    : watch_(cmark_syntax_extension_new("references")) {
  cmark_syntax_extension_set_private(watch_.get(), &defined_, nullptr);
  cmark_syntax_extension_set_postprocess_func(watch_.get(), look);
  cmark_parser_attach_syntax_extension(parser, watch_.get());
}

void ReferenceLosses::note(std::string_view text, int first_line, Losses& losses) const {
  if (defined_.empty()) return;
  static const RE2 definition(R"([ \t>*+\-.)0-9]*(\[((?:[^\[\]\\]|\\.)+)\]):)");
  const std::map<std::string, int> named = names_in(text, defined_);
  std::map<std::string, std::size_t> seen;
  int line = first_line;
  for (std::size_t at = 0; at < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    re2::StringPiece rest(text.data() + at, end - at), mark, name;
    at = end + 1;
    if (!RE2::Consume(&rest, definition, &mark, &name)) continue;
    const auto found = defined_.find(compared({name.data(), name.size()}));
    if (found == defined_.end()) continue;
    const std::vector<std::string>& addresses = found->second;
    const std::size_t which = seen[found->first]++;
    if (which >= addresses.size() || is_comment(addresses[which])) continue;
    const bool is_other = which > 0 && addresses[which] != addresses[0];
    const bool is_used = named.at(found->first) > static_cast<int>(addresses.size());
    if (is_used && !is_other) continue;
    losses.push_back({is_used ? Loss::Kind::second_reference : Loss::Kind::reference, line,
                      mark.as_string(), 0, mark.size(), name.as_string()});
  }
}

}  // namespace mjcourse
