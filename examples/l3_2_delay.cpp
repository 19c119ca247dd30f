// Lesson 3.2, exercise: a sensor that is late.
//
// INPUT    a delay in steps; the true tilt of the box in motion
// PROCESS  keep the last readings in a ring, and hand out the oldest
// OUTPUT   by how much a late reading is wrong; checks its age, and what it
//          says before the ring is full
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l3_2_delay

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mjcourse/imu.hpp>
#include <vector>

using namespace mjcourse;

// Call it once in each step with the reading of now. It gives the reading of
// `steps` steps before, and while there is none that old, the first one.
class Delay {
 public:
  explicit Delay(int steps) : ring_(steps + 1) {}

  double operator()(double now) {
    // #region answer
    if (!begun_) std::fill(ring_.begin(), ring_.end(), now);
    begun_ = true;
    ring_[next_] = now;
    next_ = (next_ + 1) % ring_.size();
    return ring_[next_];  // the oldest: the next to be overwritten
    // #starter
    // return now;  // ring_, next_ and begun_ are there for you
    // #wrong reads-before-it-writes: a reading is as old as it should be
    // if (!begun_) std::fill(ring_.begin(), ring_.end(), now);
    // begun_ = true;
    // const double oldest = ring_[next_];
    // ring_[next_] = now;
    // next_ = (next_ + 1) % ring_.size();
    // return oldest;
    // #wrong skips-one: a reading is as old as it should be
    // if (!begun_) std::fill(ring_.begin(), ring_.end(), now);
    // begun_ = true;
    // ring_[next_] = now;
    // next_ = (next_ + 1) % ring_.size();
    // return ring_[(next_ + 1) % ring_.size()];
    // #wrong begins-with-zeros: until then, it gives the first reading
    // ring_[next_] = now;
    // next_ = (next_ + 1) % ring_.size();
    // return ring_[next_];
    // #endregion
  }

 private:
  std::vector<double> ring_;  // steps + 1 numbers
  std::size_t next_ = 0;      // the place of the next reading
  bool begun_ = false;
};

int main() {
  for (const int steps : {0, 1, 5, 15}) {
    Delay delay(steps);
    for (int n = 0; n < 50; ++n) {
      const double reading = 100 + n, late = delay(reading);
      if (n >= steps &&
          !expect_near(late, reading - steps, 0,
                       "a reading is as old as it should be",
                       "with " + std::to_string(steps) +
                           " steps of delay, the readings are 100, 101, …; "
                           "which place holds the oldest once the new one "
                           "is written?"))
        return 0;
    }
  }
  Delay delay(5);
  for (int n = 0; n < 5; ++n)
    expect_near(delay(100 + n), 100, 0,
                "until then, it gives the first reading",
                "a ring of zeros would tell a controller of a jump");

  const std::vector<ImuSample> run = record_imu(3, true, 10);
  std::printf("delay (ms)  off by (degrees)  speed times delay\n");
  for (const int steps : {1, 5, 15}) {
    Delay late(steps);
    double off = 0, speed = 0;
    for (std::size_t n = 0; n < run.size(); ++n) {
      off = std::max(off, std::abs(late(run[n].tilt) - run[n].tilt));
      if (n == 0) continue;
      speed = std::max(speed, std::abs(run[n].tilt - run[n - 1].tilt) / 0.002);
    }
    std::printf("%10d  %16.2f  %17.2f\n", 2 * steps, off * 180 / M_PI,
                speed * 0.002 * steps * 180 / M_PI);
    result("off_" + std::to_string(steps), off * 180 / M_PI);
  }
}
