#include "evaluate/shard.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include "base/sha256.h"
#include "evaluate/page_task.h"
#include "evaluate/program_task.h"

namespace mjcourse {
namespace {

using std::chrono::microseconds;

// Of things that are joined two by two: which of them stands for all that it was joined with.
class Joined {
 public:
  explicit Joined(std::size_t count) : joined_(count) {
    std::iota(joined_.begin(), joined_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t one) {
    while (joined_[one] != one) one = joined_[one] = joined_[joined_[one]];
    return one;
  }
  // The first stands for both.
  void join(std::size_t a, std::size_t b) {
    const auto [first, second] = std::minmax(find(a), find(b));
    joined_[second] = first;
  }

 private:
  std::vector<std::size_t> joined_;
};

// Can another shard do it than the one that has the block's result? The model's page is none, and
// what a program is in the page is told beside it.
bool is_apart_from_block(const Task& task) {
  return !task.model().empty() || dynamic_cast<const PageTask*>(&task) != nullptr;
}

// For each task, the first of those that it is done with.
std::vector<std::size_t> together(const Tasks& tasks) {
  Joined joined(tasks.size());
  std::map<std::string, std::size_t> programs;  // by the names that are quoted
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> blocks;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (const auto* program = dynamic_cast<const ProgramTask*>(tasks[i].get())) {
      joined.join(programs.try_emplace(program->program().name(), i).first->second, i);
    }
    if (is_apart_from_block(*tasks[i])) continue;
    joined.join(blocks.try_emplace({tasks[i]->page(), tasks[i]->block()}, i).first->second, i);
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    for (const std::string& name : tasks[i]->quoted()) {
      if (const auto quoted = programs.find(name); quoted != programs.end()) {
        joined.join(quoted->second, i);
      }
    }
  }
  std::vector<std::size_t> first(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) first[i] = joined.find(i);
  return first;
}

// Of what each shard has to do so far; the one that has least, and of several the first, on top.
using Loads =
    std::priority_queue<std::pair<microseconds, std::size_t>,
                        std::vector<std::pair<microseconds, std::size_t>>, std::greater<>>;

void deal_out(const std::vector<Portion>& portions, std::vector<std::size_t> which,
              microseconds Portion::*time, std::vector<microseconds> loads,
              std::vector<std::size_t>& shards) {
  std::ranges::sort(which, [&](std::size_t a, std::size_t b) {
    const Portion &one = portions[a], &other = portions[b];
    return std::tie(other.*time, one.name, a) < std::tie(one.*time, other.name, b);
  });
  Loads least;
  for (std::size_t i = 0; i < loads.size(); ++i) least.emplace(loads[i], i);
  for (const std::size_t one : which) {
    auto [load, shard] = least.top();
    least.pop();
    shards[one] = shard + 1;
    // What takes no time at all is spread, too.
    least.emplace(load + std::max(portions[one].*time, microseconds(1)), shard);
  }
}

}  // namespace

std::vector<std::size_t> deal(const std::vector<Portion>& portions, std::size_t shards) {
  std::vector<std::size_t> dealt(portions.size()), edited, kept;
  for (std::size_t i = 0; i < portions.size(); ++i) {
    (portions[i].edited > microseconds(0) ? edited : kept).push_back(i);
  }
  std::vector<microseconds> loads(shards);
  deal_out(portions, edited, &Portion::edited, loads, dealt);
  for (const std::size_t one : edited) loads[dealt[one] - 1] += portions[one].kept;
  deal_out(portions, kept, &Portion::kept, loads, dealt);
  return dealt;
}

Share::Share(Tasks& tasks, const Shard& shard, const TaskTimes& times,
             const RunContext& run_context)
    : is_first_(shard.is_first()) {
  const std::vector<std::size_t> first = together(tasks);
  std::map<std::size_t, std::size_t> portion_of;  // by their first tasks
  std::vector<Portion> portions;
  WorkerContext worker_context(run_context);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const auto [at, is_new] = portion_of.try_emplace(first[i], portions.size());
    if (is_new) portions.push_back({tasks[i]->name_in_course()});
    Finding said;  // by the shard that works on it
    if (!tasks[i]->prepare(worker_context, said)) continue;
    const auto [lasts, is_edited] = times.of(*tasks[i], tasks[i]->recipe(run_context));
    Portion& portion = portions[at->second];
    (is_edited ? portion.edited : portion.kept) += lasts;
  }
  const std::vector<std::size_t> shards = deal(portions, shard.count);
  Sha256 division;
  Tasks ours;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const std::size_t number = shards[portion_of.at(first[i])];
    division.add(tasks[i]->name_in_course()).add(std::to_string(number));
    const bool is_ours = number == shard.number;
    note(*tasks[i], is_ours);
    if (is_ours) ours.push_back(std::move(tasks[i]));
  }
  tasks = std::move(ours);
  division_ = division.hex().substr(0, 8);
}

void Share::note(const Task& task, bool is_ours) {
  if (const auto* program = dynamic_cast<const ProgramTask*>(&task)) {
    is_ours_[program->program().file.text] = is_ours;
    if (!is_ours) programs_of_others_.push_back(program->program().name());
  }
  if (is_apart_from_block(task)) return;
  Blocks& blocks = worked_on_[&task.lesson()];
  for (const std::size_t block : task.blocks())
    (is_ours ? blocks.ours : blocks.others).insert(block);
}

std::set<std::size_t> Share::blocks_of_others(const Lesson& page) const {
  const auto known = worked_on_.find(&page);
  const Blocks blocks = known == worked_on_.end() ? Blocks() : known->second;
  std::set<std::size_t> others = blocks.others;
  for (std::size_t i = 0; i < page.blocks.size(); ++i) {
    if (blocks.others.contains(i) || blocks.ours.contains(i)) continue;
    const auto* region = std::get_if<Example>(&page.blocks[i]);
    const auto* output = std::get_if<Output>(&page.blocks[i]);
    const auto program = is_ours_.find(region != nullptr ? region->file.text : "");
    const bool is_ours = program != is_ours_.end() ? program->second
                         : output != nullptr       ? !others.contains(output->example)
                                                   : is_first_;
    if (!is_ours) others.insert(i);
  }
  return others;
}

}  // namespace mjcourse
