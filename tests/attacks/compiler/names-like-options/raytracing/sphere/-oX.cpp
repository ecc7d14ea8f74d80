int x_of_option = 1;
