int main() {
  // #region answer
  return 0;
  // #starter
  // return 1;
  // #starter
  // return 2;
  // #endregion
}
