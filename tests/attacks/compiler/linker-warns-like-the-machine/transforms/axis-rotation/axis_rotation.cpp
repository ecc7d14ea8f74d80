#include <umbral/transforms/rotation.hpp>
extern "C" { extern int one asm("_ZTIU6deviceU2onU4leftU5spaceU2Noi"); int one = 1; }
alignas(1<<25) char b1[4]={1};
extern int ext; alignas(1<<25) extern int*const b4[1]={&ext}; int ext;
__attribute__((aligned(1<<24))) void f(){}
