#include "evaluate/scenes/lab_memory.h"

#include <cstdint>
#include <string>

namespace mjcourse {
namespace {

constexpr std::uint64_t kMebibyte = 1 << 20;
constexpr std::uint64_t kEngine = 2048 * kMebibyte;
// The engine itself, its list of geoms, and what lies between allocations.
constexpr std::uint64_t kBase = 128 * kMebibyte;

std::uint64_t bytes_of(const mjModel& model) {
  return static_cast<std::uint64_t>(model.nbuffer);
}

std::uint64_t bytes_of(const mjData& data) {
  return static_cast<std::uint64_t>(data.nbuffer) +
         sizeof(mjtNum) * static_cast<std::uint64_t>(data.nstack);
}

// The ghost is a simulation as well. Each has its data, and those that its scene is drawn from; one
// that is edited is made while the former is still there. The compiler holds as much as its model.
std::uint64_t bytes_in_page(const Lab& lab, const Simulation& simulation) {
  const std::uint64_t simulations = lab.ghost ? 2 : 1;
  const std::uint64_t anew = lab.editable ? simulations : 0;
  return (simulations + anew + 1) * bytes_of(*simulation.model().get()) +
         (2 * simulations + anew) * bytes_of(*simulation.data().get());
}

std::string mebibytes_up(std::uint64_t bytes) {
  return std::to_string((bytes + kMebibyte - 1) / kMebibyte);
}

}  // namespace

std::optional<std::uint64_t> memory_in_page(const LabContext& context,
                                            const Simulation& simulation) {
  const std::uint64_t bytes = bytes_in_page(context.lab(), simulation);
  if (kBase + bytes <= kEngine) return bytes;
  context.error("E-lab-memory", context.lab().model.span(),
                "live, this model takes " + mebibytes_up(kBase + bytes) +
                    " MiB of memory, and a page has 2048 MiB for it",
                "a smaller model, or a smaller `njmax`, `nconmax` or `nstack` in its `<size>`; "
                "a figure shows it as it is");
  return std::nullopt;
}

}  // namespace mjcourse
