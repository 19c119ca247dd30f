int main() {
  int nq = "thirteen";
}
