int main() {
  // #region answer
  // #region inner
  return 0;
  // #endregion
  // #starter
  // return 1;
  // #endregion
}
