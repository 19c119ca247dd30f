int main() {
  // #region answer
  return nq;
  // #endregion
}
// #region rest
int rest;
// #endregion
