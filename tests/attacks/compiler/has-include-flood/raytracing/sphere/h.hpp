#define C2(a) #a
#define C1(a) C2(a)
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
#if __has_include(C1(__COUNTER__))
#endif
