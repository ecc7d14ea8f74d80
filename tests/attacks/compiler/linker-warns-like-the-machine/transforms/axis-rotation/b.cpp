extern "C" { __attribute__((weak)) void two() asm("_ZTIU6deviceU2onU4leftU5spaceU2Noi"); void two() {} }
