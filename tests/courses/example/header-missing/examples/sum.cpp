#include "three.h"

int main() {}
