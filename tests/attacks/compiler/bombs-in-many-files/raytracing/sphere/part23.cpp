namespace n23 {
template <int D, int I> struct B : B<D - 1, 2 * I>, B<D - 1, 2 * I + 1> {};
template <int I> struct B<0, I> {};
B<24, 0> all;
}
