int umbral_red_helper(int x);
int umbral_red_helper(int x) { return x + 1; }
