int a4 = 1;
