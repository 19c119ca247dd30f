int count();

int main() {
  return count();
}
