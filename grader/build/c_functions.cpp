#include "build/c_functions.hpp"

#include <array>
#include <cctype>

#include "build/spelling.hpp"

namespace umbral::grader {
namespace {

/// What reaches out of the run, or changes what the driver stands on, is refused; what computes from its arguments, and
/// what a run survives by what attacks prove (exit, abort, output), is allowed.
constexpr CFamily families[] = {
    {"what the compiler, the linker and the C++ library's headers call by themselves",
     "_Unwind_Resume __gmon_start__ __stack_chk_fail __chk_fail __fortify_fail __tls_get_addr __libc_single_threaded "
     "_ITM_deregisterTMCloneTable _ITM_registerTMCloneTable _GLOBAL_OFFSET_TABLE_ __dso_handle __cxa_atexit "
     "__cxa_finalize __cxa_thread_atexit_impl __errno_location",
     true},
    {"kinds of characters",
     "isalnum isalpha isascii isblank iscntrl isctype isdigit isgraph islower isprint ispunct isspace isupper isxdigit "
     "isw* toascii tolower toupper tow* wctype wctrans ctype_b_loc ctype_tolower_loc ctype_toupper_loc "
     "ctype_get_mb_cur_max",
     true},
    {"bytes and texts in memory",
     "memccpy memchr memcmp memcmpeq memcpy memfrob memmem memmove mempcpy memrchr memset bcmp bcopy bzero "
     "explicit_bzero ffs ffsl ffsll index rindex rawmemchr strcasecmp strcasestr strcat strchr "
     "strchrnul strcmp strcoll strcpy strcspn strdup strlen strncasecmp strncat strncmp strncpy strndup strnlen "
     "strpbrk strrchr strsep strspn strstr strtok strtok_r strverscmp strxfrm stpcpy stpncpy strerror strerror_r "
     "strlcpy strlcat swab xpg_strerror_r",
     true},
    {"wide texts in memory",
     "wcp* wcs* wcwidth wmem* btowc wctob wctomb wcrtomb mblen mbrlen mbrto* mbsinit mbsnrtowcs mbsrtowcs mbstowcs "
     "mbtowc c8rtomb c16rtomb c32rtomb",
     true},
    {"numbers from texts and to them",
     "ato? atoll atof strtod strtof* strtol strtold strtoll strtoul strtoull strtoq strtouq strtoimax strtoumax "
     "strtod_nan strfrom* ecvt ecvt_r fcvt fcvt_r gcvt qecvt qecvt_r qfcvt qfcvt_r qgcvt a64l l64a",
     true},
    {"whole numbers", "abs labs llabs imaxabs div ldiv lldiv imaxdiv stdc_* htonl htons ntohl ntohs", true},
    {"memory",
     "malloc calloc realloc reallocarray free cfree free_sized free_aligned_sized aligned_alloc posix_memalign "
     "memalign valloc malloc_usable_size",
     true},
    {"sorting and searching", "bsearch qsort qsort_r lfind lsearch tsearch tfind tdelete twalk twalk_r tdestroy", true},
    {"random numbers that follow from a seed",
     "rand rand_r srand random random_r srandom srandom_r initstate initstate_r setstate setstate_r *rand48 "
     "*rand48_r seed48 seed48_r lcong48 lcong48_r",
     true},
    {"time",
     "clock time difftime clock_gettime clock_getres gettimeofday timespec_get timespec_getres gmtime gmtime_r timegm "
     "asctime asctime_r",
     true},
    {"output",
     "printf fprintf vprintf vfprintf snprintf vsnprintf sprintf vsprintf asprintf vasprintf putc putchar puts fputc "
     "fputs fwrite fflush ferror feof clearerr perror wprintf fwprintf vwprintf vfwprintf swprintf vswprintf putwc "
     "putwchar fputwc fputws fwide stdout stderr overflow woverflow",
     true},
    {"values read from texts in memory", "sscanf vsscanf swscanf vswscanf localeconv", true},
    {"locks within a run",
     "pthread_mutex_* pthread_mutexattr_* pthread_rwlock_* pthread_cond_* pthread_once pthread_self pthread_equal "
     "pthread_key_create pthread_key_delete pthread_getspecific pthread_setspecific sched_yield mtx_* call_once tss_*",
     true},
    {"the end of a run, which counts as a crash", "abort exit assert assert_fail assert_perror_fail", true},

    {"starts threads or changes them", "pthread_* thrd_* cnd_* sem_* sched_* *affinity* *atfork", false},
    {"starts or changes processes, or asks about them",
     "system popen pclose *fork daemon exec* fexecve posix_spawn* wait wait? waitid waitpid ptrace prctl arch_prctl "
     "clone unshare setns personality prlimit* *rlimit* nice *priority get*id set*id *groups* syscall vhangup capget "
     "capset pidfd_* getcontext setcontext makecontext swapcontext acct reboot chroot pivot_root process_*",
     false},
    {"ends a run past what the grader sees of it", "_exit _Exit quick_exit at_quick_exit cxa_at_quick_exit on_exit",
     false},
    {"jumps over C++'s calls", "longjmp _longjmp siglongjmp setjmp _setjmp sigsetjmp longjmp_chk", false},
    {"loads libraries or looks functions up by name", "dl* _dl_* *dlsym libc_dlerror_result", false},
    {"maps or protects memory",
     "*mmap* *munmap* mprotect mremap m*advise *mlock* *munlock* msync mincore brk *sbrk shm* pkey_* remap_file_pages "
     "memfd_create mallopt *_hook morecore mtrace muntrace mcheck* mprobe",
     false},
    {"handles signals or timers",
     "*signal* sig* raise kill killpg tgkill alarm ualarm *itimer timer_* timerfd_* eventfd* pause abort2 psig*",
     false},
    {"sleeps or waits for others", "sleep usleep nanosleep clock_nanosleep *poll *select epoll_*", false},
    {"talks to the network or asks about it",
     "socket* bind connect accept accept4 listen send* recv* shutdown *sockopt getpeername getsockname *addr* *host* "
     "*net* *proto* *serv* *rpc* inet* ns_* res_* if_* ether_* sethostname *domainname rcmd* rexec* clnt* svc* xdr* "
     "auth* pmap_* bindresvport *iruserok* *ruserok*",
     false},
    {"reads or changes the environment", "getenv secure_getenv putenv setenv unsetenv clearenv environ _environ",
     false},
    {"asks about the machine or its users",
     "get*nam* get*ent* set*ent end*ent get*uid* get*gid* getlogin* cuserid uname sysconf confstr sysinfo getauxval "
     "getloadavg get_nprocs* get_*phys_pages getpagesize getrusage times gethostid getcpu sysctl syslog vsyslog "
     "openlog closelog backtrace* getopt*",
     false},
    {"takes random numbers of the machine, other ones in each run", "arc4random* getrandom getentropy strfry", false},
    {"reads settings of the machine: time zone, language",
     "localtime* mktime ctime* tzset tzname timezone daylight strftime getdate* strptime setlocale newlocale "
     "uselocale duplocale freelocale nl_langinfo *gettext* textdomain bind*textdomain* cat* iconv*",
     false},
    {"sets a clock", "settimeofday stime adjtime* ntp_* clock_settime clock_adjtime", false},
    {"reads what is typed, or from files", "get* *scanf fget* fread ungetc ungetwc stdin uflow underflow", false},
    {"opens or changes files, or asks about them",
     "*open* *close* creat* read* write* p*read* p*write* lseek* fseek* ftell* fgetpos* fsetpos* rewind* *stat* "
     "*stat64 "
     "*chmod* *chown* access faccessat eaccess euidaccess *link* *rename* remove *mkdir* *rmdir* *mknod* *mkfifo* "
     "mktemp mk*temp* tmp* tempnam *dir* fcntl* ioctl *lockf* flock* dup dup2 dup3 pipe pipe2 fileno* *sync* "
     "*truncate* *fallocate* *fadvise* *xattr* *mount* *chdir getcwd *utime* umask glob* wordexp* nftw* ftw* fts* "
     "*buf setvbuf setbuffer setlinebuf splice tee vmsplice sendfile* copy_file_range inotify_* fanotify_* aio_* "
     "lio_* mq_* msg* sem* isatty isastream isfdtype *tty* pty* grantpt unlockpt tc* cf* dprintf vdprintf realpath "
     "canonicalize_file_name swapo* quotactl",
     false}};

bool holds_name(std::string_view names, std::string_view name)
{
    while (!names.empty()) {
        const std::size_t space = names.find(' ');
        const std::string_view pattern = names.substr(0, space);
        if (matches_pattern(name, pattern)) return true;
        if (space == std::string_view::npos) break;
        names.remove_prefix(space + 1);
    }
    return false;
}

const CFamily* listed_family(std::string_view name)
{
    for (const CFamily& family : families)
        if (holds_name(family.names, name)) return &family;
    return nullptr;
}

bool drop_suffix(std::string_view& name, std::string_view suffix)
{
    if (!name.ends_with(suffix) || name.size() == suffix.size()) return false;
    name.remove_suffix(suffix.size());
    return true;
}

/// `strtol` of `__isoc23_strtol`, `__strtol_internal` and `strtol_l`.
std::string_view plain_name(std::string_view name)
{
    constexpr std::string_view iso = "__isoc";
    constexpr std::size_t year_and_line = 3;
    if (name.starts_with(iso) && name.size() > iso.size() + year_and_line && name[iso.size() + 2] == '_')
        name.remove_prefix(iso.size() + year_and_line);
    else if (name.starts_with("__"))
        name.remove_prefix(2);
    for (const std::string_view suffix : {"_chk", "_internal", "_unlocked", "_l"})
        if (drop_suffix(name, suffix)) break;
    return name;
}

}

const CFamily* c_family(std::string_view symbol)
{
    const CFamily* const as_it_is = listed_family(symbol);
    if (as_it_is != nullptr && as_it_is->allowed) return as_it_is;
    const CFamily* const plain = listed_family(plain_name(symbol));
    return plain != nullptr && (plain->allowed || as_it_is == nullptr) ? plain : as_it_is;
}

}
