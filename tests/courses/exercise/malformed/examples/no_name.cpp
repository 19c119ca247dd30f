int main() {
  // #region answer
  return 0;
  // #starter
  // return 1;
  // #wrong it is 0
  // return 2;
  // #endregion
}
