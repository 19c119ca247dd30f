#include "cli/timings.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/counted.h"
#include "cli/size.h"

namespace mjcourse {
namespace {

constexpr std::size_t kRows = 20;

std::string milliseconds(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%9.1f ms", 1000 * seconds);
  return text;
}

std::string page_text(const TaskTime& time) {
  if (time.in_page == 0) return "";
  char text[48];
  std::snprintf(text, sizeof text, ", %.1f s of it in the page", time.in_page);
  return text;
}

}  // namespace

std::string timings_table(const std::vector<TaskTime>& times) {
  std::vector<TaskTime> worked;
  double kept = 0;
  for (const TaskTime& time : times) {
    if (time.reused) {
      kept += time.seconds;
    } else {
      worked.push_back(time);
    }
  }
  std::stable_sort(worked.begin(), worked.end(),
                   [](const TaskTime& a, const TaskTime& b) { return a.seconds > b.seconds; });
  std::string text;
  double others = 0, in_page = 0;
  for (std::size_t i = 0; i < worked.size(); ++i) {
    if (i < kRows) {
      text += milliseconds(worked[i].seconds) + "  " + worked[i].what + page_text(worked[i]) + "\n";
    } else {
      others += worked[i].seconds;
    }
    in_page += worked[i].in_page;
  }
  if (worked.size() > kRows) {
    text += milliseconds(others) + "  " + counted(worked.size() - kRows, "other task") + "\n";
  }
  if (in_page > 0) {
    text += milliseconds(in_page) + "  of all these in the page\n";
  }
  const std::size_t reused = times.size() - worked.size();
  if (reused > 0) {
    text += milliseconds(kept) + "  " + counted(reused, "result") + " kept from before\n";
  }
  return text;
}

std::string traffic_text(const RemoteStore::Traffic& traffic) {
  return milliseconds(traffic.waited) +
         "  for the shared store, of all threads together: " + std::to_string(traffic.found) +
         " of " + counted(traffic.found + traffic.missed, "entry", "entries") + " found (" +
         size_text(traffic.received) + "), " + std::to_string(traffic.put) + " put (" +
         size_text(traffic.sent) + ")\n";
}

void write_trace(const std::vector<TaskTime>& times, const OutPlace& place) {
  constexpr double kMicroseconds = 1e6;
  nlohmann::json events = nlohmann::json::array();
  for (const TaskTime& time : times) {
    events.push_back({{"name", time.what},
                      {"cat", time.reused ? "kept" : "worked"},
                      {"ph", "X"},  // a complete event
                      {"ts", time.begin * kMicroseconds},
                      {"dur", time.seconds * kMicroseconds},
                      {"pid", 1},
                      {"tid", time.thread},
                      {"args", {{"seconds in the page", time.in_page}}}});
  }
  place.folder.write(place.name, nlohmann::json{{"traceEvents", std::move(events)}}.dump() + "\n");
}

}  // namespace mjcourse
