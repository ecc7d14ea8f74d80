// LeakSanitizer asks for this by name: OSMesa keeps a few hundred bytes of each context that was made current, whoever
// destroys it.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
