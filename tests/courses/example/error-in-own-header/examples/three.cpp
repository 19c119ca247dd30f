#include "../elsewhere/wheel.h"

int main() {}
