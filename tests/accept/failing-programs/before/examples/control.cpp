#include <cstdio>
int main() { std::puts("a\n50%\r100%"); }
