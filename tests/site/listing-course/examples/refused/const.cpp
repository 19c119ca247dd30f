int main() {
  const int n = 1;
  n = 2;
}
