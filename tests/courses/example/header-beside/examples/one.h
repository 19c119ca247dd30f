const int kOne = 1;
