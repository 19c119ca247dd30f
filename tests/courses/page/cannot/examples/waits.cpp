#include <condition_variable>
#include <mutex>
#include <thread>

int main() {
  std::mutex mutex;
  std::condition_variable told;
  bool go = false;
  std::thread waits([&] {
    std::unique_lock lock(mutex);
    told.wait(lock, [&] { return go; });
  });
  {
    const std::lock_guard lock(mutex);
    go = true;
  }
  told.notify_one();
  waits.join();
}
