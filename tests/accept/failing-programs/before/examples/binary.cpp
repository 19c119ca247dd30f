#include <cstdio>
int main() { std::puts("a\xff"); }
