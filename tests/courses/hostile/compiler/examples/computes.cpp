constexpr int wait_for_ever() {
  for (int i = 0;; i = 1 - i) {
  }
  return 0;
}

int main() {
  constexpr int never = wait_for_ever();
  return never;
}
