char ground[1L << 42] = {1};

int main() {
  return ground[1];
}
