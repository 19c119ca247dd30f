int main() {
  // #region answer
  return 0;
  // #startr
  // return 1;
  // #endregion
}
