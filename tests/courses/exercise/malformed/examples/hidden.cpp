int main() {
  // #region answer
  return 0;
  // #endregion
}
