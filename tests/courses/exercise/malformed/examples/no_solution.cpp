int main() {
  // #region answer
  // #starter
  // return 1;
  // #endregion
}
