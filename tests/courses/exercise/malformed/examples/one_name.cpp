int main() {
  // #region answer
  return 0;
  // #starter
  // return 1;
  // #wrong odd: it is 0
  // return 2;
  // #wrong odd: it is 0
  // return 4;
  // #endregion
}
