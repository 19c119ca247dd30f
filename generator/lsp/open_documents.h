// OpenDocuments: a course's files as its author sees them: those that are open in the editor as
// they are there, saved or not, and the others as they lie on the disk.
//
// Any thread may read while another takes what was typed.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "lsp/text_point.h"

namespace mjcourse {

class OpenDocuments : public Files {
 public:
  explicit OpenDocuments(const std::filesystem::path& root);

  const std::filesystem::path& root() const { return root_; }
  // The file's name in the course; nothing where it is none of the course's.
  std::optional<std::string> name_of(std::string_view uri) const;
  std::string uri_of(const std::string& name) const;

  struct Change {
    std::optional<TextRange> range;  // nothing: all of it
    std::string text;
  };
  // `contentChanges`, as the protocol has them. Throws nlohmann's exceptions.
  static std::vector<Change> read_changes(const nlohmann::json& changes);
  void open(const std::string& name, std::string text);
  // One after the other. What is not open stays closed.
  void change(const std::string& name, const std::vector<Change>& changes, Units units);
  void close(const std::string& name);

  // What is open.
  std::vector<std::string> names() const;
  // Null where it is not open.
  std::shared_ptr<const SourceText> text(const std::string& name) const;
  // The same, or what lies on the disk; null where there is nothing, or no UTF-8.
  std::shared_ptr<const SourceText> text_or_saved(const std::string& name) const;

  tl::expected<std::string, std::string> read(const std::string& path) const override;
  bool exists(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::vector<std::string> folders(const std::string& folder) const override;
  std::vector<std::string> list_below(const std::string& folder) const override;
  std::optional<FileRefusal> refusal(const std::string& path) const override;

 private:
  std::filesystem::path root_;
  DiskFiles saved_;
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const SourceText>> open_;
};

}  // namespace mjcourse
