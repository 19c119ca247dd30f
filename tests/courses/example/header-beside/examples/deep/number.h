const int kNumber = 7;
