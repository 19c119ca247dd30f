volatile bool deeper = true;

int dig(int depth) {
  volatile char ground[1000] = {};
  return deeper ? dig(depth + 1) + ground[depth % 1000] : 0;
}

int main() {
  return dig(0);
}
