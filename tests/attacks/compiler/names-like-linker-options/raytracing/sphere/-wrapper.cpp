int a1 = 1;
