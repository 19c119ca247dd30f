#include "cli/settled_grades.h"

#include <utility>

#include "base/parallel.h"

namespace mjcourse {

std::vector<Grade> settled_grades(std::size_t count, std::size_t jobs, const GradeWork& work) {
  std::vector<Grade> grades(count);
  for_each_index(count, jobs, [&](std::size_t i, std::size_t) {
    grades[i] = work.judge(i);
    if (!grades[i].may_be_of_others()) work.done(i, grades[i]);
  });
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < count; ++i) {
    if (grades[i].may_be_of_others()) open.push_back(i);
  }
  if (!open.empty()) work.again(open.size());
  for (const std::size_t i : open) {
    grades[i] = work.judge(i);
    work.done(i, grades[i]);
  }
  return grades;
}

}  // namespace mjcourse
