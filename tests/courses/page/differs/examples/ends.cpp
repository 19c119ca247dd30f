int main() {
  return sizeof(long) == 8 ? 0 : 3;
}
