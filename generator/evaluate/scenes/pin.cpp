#include "evaluate/scenes/pin.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "course/reference_picture.h"
#include "physics/picture_difference.h"
#include "physics/thumbnail.h"
#include "process/our_command.h"
#include "report/refused_file.h"

namespace mjcourse {
namespace {

constexpr int kReferenceWidth = 160;  // pixels, of a new reference

std::string accept_cure() {
  return "look at it (`check --report DIR` shows it); if it is as intended, " +
         our_command("accept") + " keeps it as the reference";
}

// Of `picture` made `width` wide.
int height_at(int width, const Picture& picture) {
  const double height = static_cast<double>(picture.height) * width / picture.width;
  return std::max(1, static_cast<int>(std::lround(height)));
}

std::string size_text(const Picture& picture) {
  return std::to_string(picture.width) + " × " + std::to_string(picture.height);
}

// "0.2 %"; nothing that differs is 0.
std::string percent(const PictureDifference& difference) {
  const double share =
      100.0 * static_cast<double>(difference.pixels) / static_cast<double>(difference.of);
  char text[16];
  std::snprintf(text, sizeof text, "%.1f %%", std::max(share, 0.1));
  return text;
}

class Pin {
 public:
  Pin(const LocatedText& pin, const Picture& picture, const BlockContext& context)
      : pin_(pin),
        picture_(picture),
        context_(context),
        path_(reference_path(context.lesson(), pin.text)) {}

  PinComparison compare() {
    result_.name = pin_.text;
    keep(std::min(kReferenceWidth, picture_.width));
    const Files& files = context_.worker_context().files();
    if (const auto refusal = files.refusal(path_)) {
      context_.diagnostics().push_back(
          refused_file(place_of(*context_.lesson().source, pin_.span()), path_, *refusal));
      return result_;
    }
    // The target of a link is no reference, and `accept` would write over it.
    if (std::filesystem::is_symlink(context_.worker_context().root() / path_)) {
      context_.diagnostics().push_back(
          refused_file(place_of(*context_.lesson().source, pin_.span()), path_,
                       {"is a link", "put the picture itself there"}));
      return result_;
    }
    if (!files.exists(path_)) {
      report("E-picture-unpinned", "there is no reference picture " + path_ + " yet",
             accept_cure());
      return result_;
    }
    const auto bytes = files.read(path_);
    const auto reference = bytes ? decode_png(*bytes) : tl::unexpected(bytes.error());
    if (!reference) {
      report("E-picture-unreadable",
             "the reference picture " + path_ + " cannot be read: " + reference.error(),
             "bring it back from your version control, or let " + our_command("accept") +
                 " make it again");
      return result_;
    }
    result_.reference = Blob(*bytes);
    compare_with(*reference);
    return result_;
  }

 private:
  void keep(int width) {
    small_ = shrink(picture_, width, height_at(width, picture_));
    actual_ = encode_png(small_);
    result_.actual = Blob(actual_);
  }

  void compare_with(const Picture& reference) {
    if (reference.width > picture_.width ||
        reference.height != height_at(reference.width, picture_)) {
      report("E-picture-differs",
             "this picture does not have the shape of its reference " + path_ + ": that is " +
                 size_text(reference) + " pixels, and this would be " + size_text(small_),
             accept_cure());
      return;
    }
    keep(reference.width);
    const PictureDifference difference = mjcourse::compare(reference, small_);
    result_.difference = Blob(encode_png(difference.shown));
    result_.agrees = difference.agrees;
    if (difference.agrees) return;
    report("E-picture-differs",
           percent(difference) + " of this picture differs from its reference " + path_ + ", " +
               difference.where,
           accept_cure());
  }

  void report(const char* id, const std::string& message, const std::string& cure) {
    context_.error(id, pin_.span(), message, cure);
    context_.diagnostics().back().edit =
        Edit{path_, std::nullopt, actual_,
             "the reference picture \"" + pin_.text + "\" of lesson " + context_.lesson().number};
  }

  const LocatedText& pin_;
  const Picture& picture_;
  const BlockContext& context_;
  std::string path_;
  Picture small_;       // the picture, at the reference's size
  std::string actual_;  // the same as PNG
  PinComparison result_;
};

}  // namespace

std::optional<PinComparison> compare_pin(const LocatedText& pin, const Picture& picture,
                                         const BlockContext& context) {
  if (pin.text.empty()) return std::nullopt;
  return Pin(pin, picture, context).compare();
}

}  // namespace mjcourse
