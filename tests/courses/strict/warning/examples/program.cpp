int main() {
  int unused = 0;
}
