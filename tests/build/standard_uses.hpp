#pragma once

#include <vector>

namespace umbral::grader::test {

/// Statements that use functions of the standard library; keep(number) makes the result count.
struct Use {
    const char* name;
    const char* code;
};

/// One use of every function of a header, as far as it computes. `x`, `i`, `number`, `text` and `wide` are not known
/// when they are compiled, so that nothing is computed by the compiler.
inline const std::vector<Use> standard_uses = {
    {"cmath",
     "for (double y : {std::abs(x), std::fabs(x), std::fmod(x, 3), std::remainder(x, 3), std::fma(x, x, x), "
     "std::fmax(x, 1), "
     "std::fmin(x, 1), std::fdim(x, 1), std::exp(x), std::exp2(x), std::expm1(x), std::log(x), std::log10(x), "
     "std::log2(x), "
     "std::log1p(x), std::pow(x, x), std::sqrt(x), std::cbrt(x), std::hypot(x, x), std::hypot(x, x, x), std::sin(x), "
     "std::cos(x), std::tan(x), std::asin(x), std::acos(x), std::atan(x), std::atan2(x, x), std::sinh(x), "
     "std::cosh(x), "
     "std::tanh(x), std::asinh(x), std::acosh(x), std::atanh(x), std::erf(x), std::erfc(x), std::tgamma(x), "
     "std::lgamma(x), "
     "std::ceil(x), std::floor(x), std::trunc(x), std::round(x), std::nearbyint(x), std::rint(x), std::ldexp(x, i), "
     "std::scalbn(x, i), std::scalbln(x, i), std::logb(x), std::nextafter(x, 9), std::nexttoward(x, 9.0L), "
     "std::copysign(x, -1), std::lerp(x, x, x), std::nan(text.c_str())}) keep(y);\n"
     "int e = 0; double whole = 0; keep(std::frexp(x, &e)); keep(std::modf(x, &whole)); keep(std::remquo(x, 3, &e));\n"
     "keep(std::ilogb(x)); keep(std::lround(x)); keep(std::llround(x)); keep(std::lrint(x)); keep(std::llrint(x));\n"
     "keep(std::isnan(x) + std::isinf(x) + std::isfinite(x) + std::isnormal(x) + std::signbit(x) + "
     "std::fpclassify(x));\n"
     "keep(std::isgreater(x, 1) + std::isless(x, 1) + std::isunordered(x, 1));"},
    {"cmath_float",
     "const float f = number; for (float y : {std::abs(f), std::fmod(f, 3.F), std::remainder(f, 3.F), std::fma(f, f, "
     "f), "
     "std::exp(f), std::exp2(f), std::expm1(f), std::log(f), std::log10(f), std::log2(f), std::log1p(f), std::pow(f, "
     "f), "
     "std::cbrt(f), std::hypot(f, f), std::sin(f), std::cos(f), std::tan(f), std::asin(f), std::acos(f), std::atan(f), "
     "std::atan2(f, f), std::sinh(f), std::cosh(f), std::tanh(f), std::asinh(f), std::acosh(f), std::atanh(f), "
     "std::erf(f), "
     "std::erfc(f), std::tgamma(f), std::lgamma(f), std::ceil(f), std::floor(f), std::trunc(f), std::round(f), "
     "std::nearbyint(f), std::rint(f), std::ldexp(f, i), std::logb(f), std::nextafter(f, 9.F), ::sinf(f), ::powf(f, "
     "f), "
     "std::nanf(text.c_str())}) keep(y);\nkeep(std::lroundf(f)); keep(std::lrint(f)); keep(std::llrint(f));"},
    {"cmath_long_double",
     "const long double l = x; for (long double y : {std::fmod(l, 3.L), std::exp(l), std::log(l), std::pow(l, l), "
     "std::sin(l), std::cos(l), std::tan(l), std::asin(l), std::acos(l), std::atan2(l, l), std::hypot(l, l), "
     "std::cbrt(l), "
     "std::ceil(l), std::floor(l), std::round(l), std::tgamma(l), std::erf(l), std::nextafter(l, 9.L)}) keep(y);"},
    {"cmath_special",
     "for (double y : {std::assoc_laguerre(1U, 1U, x), std::assoc_legendre(1U, 1U, x), std::beta(x, x), "
     "std::comp_ellint_1(x), "
     "std::comp_ellint_2(x), std::comp_ellint_3(x, x), std::cyl_bessel_i(1, x), std::cyl_bessel_j(1, x), "
     "std::cyl_bessel_k(1, x), std::cyl_neumann(1, x), std::ellint_1(x, x), std::ellint_2(x, x), std::ellint_3(x, x, "
     "x), "
     "std::expint(x), std::hermite(2U, x), std::laguerre(2U, x), std::legendre(2U, x), std::riemann_zeta(x), "
     "std::sph_bessel(1U, x), std::sph_legendre(1U, 1U, x), std::sph_neumann(1U, x), ::j0(x), ::j1(x), ::jn(2, x), "
     "::y0(x), "
     "::y1(x), ::yn(2, x)}) keep(y);\ndouble s = 0, c = 0; ::sincos(x, &s, &c); keep(s + c); keep(::exp10(x));"},
    {"cfenv",
     "keep(std::fegetround()); std::feclearexcept(FE_ALL_EXCEPT); keep(std::fetestexcept(FE_INVALID)); std::fenv_t e; "
     "keep(std::fegetenv(&e)); keep(std::fesetenv(&e)); keep(std::feholdexcept(&e)); keep(std::feupdateenv(&e)); "
     "keep(std::fesetround(FE_TONEAREST)); keep(std::feraiseexcept(0));"},
    {"complex",
     "const std::complex<double> z(x, x); for (const auto& w : {std::conj(z), std::proj(z), std::polar(x, x), "
     "std::exp(z), "
     "std::log(z), std::log10(z), std::pow(z, z), std::pow(z, 3), std::pow(x, z), std::sqrt(z), std::sin(z), "
     "std::cos(z), "
     "std::tan(z), std::asin(z), std::acos(z), std::atan(z), std::sinh(z), std::cosh(z), std::tanh(z), std::asinh(z), "
     "std::acosh(z), std::atanh(z), z * z, z / z, z + z, z - z}) keep(w.real() + w.imag());\n"
     "keep(std::abs(z) + std::arg(z) + std::norm(z));"},
    {"complex_float",
     "const std::complex<float> z(number, number); for (const auto& w : {std::proj(z), std::polar(1.F, z.real()), "
     "std::exp(z), "
     "std::log(z), std::pow(z, z), std::sqrt(z), std::sin(z), std::cos(z), std::tan(z), std::asin(z), std::acos(z), "
     "std::atan(z), std::sinh(z), std::cosh(z), std::tanh(z), std::asinh(z), std::acosh(z), std::atanh(z), z * z, z / "
     "z}) "
     "keep(w.real() + w.imag());\nkeep(std::abs(z) + std::arg(z)); const std::complex<long double> l(x, x); "
     "keep(std::abs(l * l / l) + std::arg(std::exp(l)) + std::abs(std::sqrt(l)) + std::abs(std::pow(l, l)));"},
    {"string",
     "keep(std::stoi(text)); keep(std::stol(text)); keep(std::stoll(text)); keep(std::stoul(text)); "
     "keep(std::stoull(text)); "
     "keep(std::stof(text)); keep(std::stod(text)); keep(std::stold(text)); keep(std::stoi(wide)); "
     "keep(std::stoll(wide)); "
     "keep(std::stod(wide)); keep(std::stof(wide)); keep(std::stoul(wide)); keep(std::stoull(wide)); "
     "keep(std::stold(wide));\n"
     "for (const std::string& s : {std::to_string(i), std::to_string(x), std::to_string(7UL), std::to_string(7.L), "
     "text.substr(0, 1), text + text}) keep(s.size()); keep(std::to_wstring(x).size() + std::to_wstring(i).size());\n"
     "std::string t = text; t.insert(0, \"a\"); t.erase(0, 1); t.replace(0, 1, \"b\"); t.append(3, 'c'); t.resize(9); "
     "keep(t.find('c') + t.rfind(\"c\") + t.find_first_of(\"ab\") + t.find_last_not_of(\"ab\") + t.compare(text)); "
     "keep(std::hash<std::string>()(t)); keep(std::string_view(t).starts_with(\"x\"));"},
    {"charconv",
     "char b[64]; std::to_chars(b, b + 64, i); std::to_chars(b, b + 64, i, 16); std::to_chars(b, b + 64, x); "
     "std::to_chars(b, b + 64, number); std::to_chars(b, b + 64, x, std::chars_format::fixed, 3); "
     "std::to_chars(b, b + 64, 7.L); double d = 0; float f = 0; int n = 0; std::from_chars(b, b + 9, d); "
     "std::from_chars(b, b + 9, f); std::from_chars(b, b + 9, n, 16); keep(d + n + static_cast<double>(f));"},
    {"cctype",
     "keep(std::isalnum(i) + std::isalpha(i) + std::isblank(i) + std::iscntrl(i) + std::isdigit(i) + std::isgraph(i) + "
     "std::islower(i) + std::isprint(i) + std::ispunct(i) + std::isspace(i) + std::isupper(i) + std::isxdigit(i) + "
     "std::tolower(i) + std::toupper(i)); int (*volatile f)(int) = &std::isalpha; keep(f(i));"},
    {"cwctype",
     "const auto w = static_cast<std::wint_t>(i); keep(std::iswalnum(w) + std::iswalpha(w) + std::iswblank(w) + "
     "std::iswcntrl(w) + std::iswdigit(w) + std::iswgraph(w) + std::iswlower(w) + std::iswprint(w) + std::iswpunct(w) "
     "+ "
     "std::iswspace(w) + std::iswupper(w) + std::iswxdigit(w)); keep(std::towlower(w) + std::towupper(w)); "
     "keep(std::iswctype(w, std::wctype(\"alpha\"))); keep(std::towctrans(w, std::wctrans(\"tolower\")));"},
    {"cwchar",
     "wchar_t b[64] = {}; wchar_t* end = nullptr; const wchar_t* const w = wide.c_str(); keep(std::wcslen(w)); "
     "std::wcsncpy(b, "
     "w, 9); std::wcscat(b, L\"x\"); std::wcsncat(b, w, 2); keep(std::wcscmp(b, w) + std::wcsncmp(b, w, 3) + "
     "std::wcscoll(b, "
     "w)); keep(std::wcschr(b, L'1') != nullptr); keep(std::wcsrchr(b, L'1') != nullptr); keep(std::wcsstr(b, w) != "
     "nullptr); "
     "keep(std::wcsspn(b, w) + std::wcscspn(b, w)); keep(std::wcspbrk(b, w) != nullptr); keep(std::wcstok(b, L\"x\", "
     "&end) != "
     "nullptr); keep(std::wcstod(w, &end)); keep(std::wcstof(w, &end)); keep(std::wcstold(w, &end)); "
     "keep(std::wcstol(w, &end, "
     "9)); keep(std::wcstoll(w, &end, 9)); keep(std::wcstoul(w, &end, 9)); keep(std::wcstoull(w, &end, 9)); "
     "std::wmemcpy(b, w, "
     "1); std::wmemmove(b, w, 1); std::wmemset(b, L'x', 3); keep(std::wmemcmp(b, w, 1)); keep(std::wmemchr(b, L'x', 9) "
     "!= "
     "nullptr); std::mbstate_t s{}; keep(std::mbrtowc(b, text.c_str(), 2, &s)); char c[64]; keep(std::wcrtomb(c, L'x', "
     "&s)); "
     "keep(std::btowc(i)); keep(std::wctob(L'x')); keep(std::mbsinit(&s)); keep(std::swprintf(b, 64, L\"%d\", i)); "
     "keep(std::mbrlen(text.c_str(), 3, &s)); const char* from = text.c_str(); keep(std::mbsrtowcs(b, &from, 9, &s)); "
     "const "
     "wchar_t* wf = w; keep(std::wcsrtombs(c, &wf, 9, &s)); int n = 0; keep(std::swscanf(w, L\"%d\", &n)); "
     "std::wcsxfrm(b, w, 9);"},
    {"cuchar",
     "std::mbstate_t s{}; char16_t a = 0; char32_t b = 0; char c[16]; keep(std::mbrtoc16(&a, text.c_str(), 2, &s)); "
     "keep(std::mbrtoc32(&b, text.c_str(), 2, &s)); keep(std::c16rtomb(c, a, &s)); keep(std::c32rtomb(c, b, &s));"},
    {"cstdlib",
     "char* end = nullptr; const char* const t = text.c_str(); keep(std::atoi(t)); keep(std::atol(t)); "
     "keep(std::atoll(t)); "
     "keep(std::atof(t)); keep(std::strtod(t, &end)); keep(std::strtof(t, &end)); keep(std::strtold(t, &end)); "
     "keep(std::strtol(t, &end, 9)); keep(std::strtoll(t, &end, 9)); keep(std::strtoul(t, &end, 9)); "
     "keep(std::strtoull(t, "
     "&end, 9)); std::srand(1); keep(std::rand()); void* p = std::malloc(9); p = std::realloc(p, 99); std::free(p); "
     "std::free(std::calloc(3, 3)); std::free(std::aligned_alloc(16, 64)); int a[] = {3, i, 1}; const auto less = "
     "[](const "
     "void* l, const void* r) { return *static_cast<const int*>(l) - *static_cast<const int*>(r); }; std::qsort(a, 3, "
     "4, "
     "less); keep(std::bsearch(&i, a, 3, 4, less) != nullptr); keep(std::abs(i) + std::labs(i) + std::llabs(i)); "
     "keep(std::div(i, 3).rem + std::ldiv(i, 3L).rem + std::lldiv(i, 3LL).rem); wchar_t w[9]; char c[16]; "
     "keep(std::mblen(t, 3)); keep(std::mbtowc(w, t, 3)); keep(std::wctomb(c, L'x')); keep(std::mbstowcs(w, t, 3)); "
     "keep(std::wcstombs(c, w, 3)); if (i == -12345) std::abort(); keep(::random()); ::srand48(3); keep(::drand48());"},
    {"cstring",
     "char b[256] = {}; const char* const t = text.c_str(); std::memcpy(b, t, text.size()); std::memmove(b + 1, b, "
     "text.size()); std::memset(b, i, 9); keep(std::memcmp(b, t, text.size())); keep(std::memchr(b, i, text.size()) != "
     "nullptr); std::strcpy(b, t); std::strncpy(b, t, 9); std::strcat(b, t); std::strncat(b, t, 3); "
     "keep(std::strcmp(b, t) + "
     "std::strncmp(b, t, text.size()) + std::strcoll(b, t)); keep(std::strlen(b)); keep(std::strchr(b, i) != nullptr); "
     "keep(std::strrchr(b, i) != nullptr); keep(std::strstr(b, t) != nullptr); keep(std::strspn(b, t) + "
     "std::strcspn(b, t)); "
     "keep(std::strpbrk(b, t) != nullptr); keep(std::strtok(b, t) != nullptr); keep(std::strerror(i)[0]); char c[64]; "
     "keep(std::strxfrm(c, t, 9)); keep(::strnlen(t, 9)); std::free(::strdup(t)); keep(::strcasecmp(b, t)); "
     "keep(::strtok_r(b, t, &*std::make_unique<char*>()) != nullptr);"},
    {"cinttypes",
     "keep(std::imaxabs(i)); keep(std::imaxdiv(i, 3).rem); char* e = nullptr; keep(std::strtoimax(text.c_str(), &e, "
     "9)); "
     "keep(std::strtoumax(text.c_str(), &e, 9)); keep(std::wcstoimax(wide.c_str(), nullptr, 9));"},
    {"cstdio",
     "char b[64]; keep(std::snprintf(b, 64, \"%f\", x)); keep(std::sprintf(b, \"%d\", i)); int n = 0; "
     "keep(std::sscanf(b, \"%d\", &n)); std::printf(\"%d\", i); std::puts(b); std::putchar(i); std::fprintf(stderr, "
     "\"%d\", "
     "i); std::fputs(b, stdout); std::fputc(i, stderr); std::putc(i, stdout); std::fwrite(b, 1, 1, stderr); "
     "std::fflush(stdout); std::perror(b); keep(std::ferror(stdout));"},
    {"ctime",
     "keep(std::clock()); const std::time_t t = std::time(nullptr); keep(std::difftime(t, 3)); "
     "keep(std::gmtime(&t)->tm_year); std::timespec s{}; keep(std::timespec_get(&s, TIME_UTC));"},
    {"chrono",
     "const auto a = std::chrono::steady_clock::now(); keep((std::chrono::steady_clock::now() - a).count()); "
     "keep(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())); "
     "keep(std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::seconds(i)).count());"},
    {"algorithm",
     "std::vector<double> v{x, 3, 1, 2}; std::sort(v.begin(), v.end()); std::stable_sort(v.begin(), v.end()); "
     "std::partial_sort(v.begin(), v.begin() + 2, v.end()); std::nth_element(v.begin(), v.begin() + 1, v.end()); "
     "std::reverse(v.begin(), v.end()); std::rotate(v.begin(), v.begin() + 1, v.end()); std::mt19937 g(1); "
     "std::shuffle(v.begin(), v.end(), g); v.erase(std::unique(v.begin(), v.end()), v.end()); "
     "std::stable_partition(v.begin(), v.end(), [](double d) { return d > 1; }); std::make_heap(v.begin(), v.end()); "
     "std::sort_heap(v.begin(), v.end()); std::inplace_merge(v.begin(), v.begin() + 1, v.end()); "
     "keep(*std::max_element(v.begin(), v.end())); keep(std::lower_bound(v.begin(), v.end(), x) - v.begin()); "
     "keep(std::clamp(x, 0., 1.)); keep(std::count_if(v.begin(), v.end(), [](double d) { return d > 1; })); "
     "std::next_permutation(v.begin(), v.end()); std::fill_n(v.begin(), 1, x); std::ranges::sort(v); "
     "std::vector<double> s; std::ranges::sample(v, std::back_inserter(s), 2, g); std::ranges::transform(v, v.begin(), "
     "[](double d) { return -d; }); keep(s.size());"},
    {"numeric",
     "std::vector<double> v(9, x); std::iota(v.begin(), v.end(), x); keep(std::accumulate(v.begin(), v.end(), 0.)); "
     "keep(std::inner_product(v.begin(), v.end(), v.begin(), 0.)); keep(std::reduce(v.begin(), v.end())); "
     "keep(std::transform_reduce(v.begin(), v.end(), v.begin(), 0.)); std::partial_sum(v.begin(), v.end(), v.begin()); "
     "std::adjacent_difference(v.begin(), v.end(), v.begin()); std::inclusive_scan(v.begin(), v.end(), v.begin()); "
     "keep(std::gcd(i, 12)); keep(std::lcm(i, 12)); keep(std::midpoint(x, 1.)); keep(std::midpoint(i, 12));"},
    {"random",
     "std::mt19937 a(1); std::mt19937_64 b(1); std::minstd_rand c(1); std::ranlux24 d(1); std::knuth_b e(1); "
     "std::seed_seq s{1, "
     "2}; std::default_random_engine f(s); keep(std::uniform_int_distribution<int>(0, 9)(a)); "
     "keep(std::uniform_real_distribution<double>(0, 1)(b)); keep(std::normal_distribution<double>(0, 1)(c)); "
     "keep(std::bernoulli_distribution(.5)(d)); keep(std::binomial_distribution<int>(9, .5)(e)); "
     "keep(std::poisson_distribution<int>(99)(f)); keep(std::exponential_distribution<double>(1)(a)); "
     "keep(std::gamma_distribution<double>(2)(a)); keep(std::weibull_distribution<double>(2)(a)); "
     "keep(std::cauchy_distribution<double>(2)(a)); keep(std::student_t_distribution<double>(2)(a)); "
     "keep(std::geometric_distribution<int>(.5)(a)); keep(std::discrete_distribution<int>{1, 2}(a)); "
     "keep(std::lognormal_distribution<double>(2)(a)); keep(std::generate_canonical<double, 53>(a));"},
    {"bit",
     "const auto u = static_cast<unsigned>(i); keep(std::popcount(u) + std::countl_zero(u) + std::countr_one(u)); "
     "keep(std::bit_ceil(u & 255U) + std::bit_floor(u) + std::bit_width(u) + std::rotl(u, i)); "
     "keep(std::has_single_bit(u)); "
     "keep(std::bit_cast<std::uint64_t>(x)); keep(std::popcount(static_cast<unsigned long long>(i)));"},
    {"limits",
     "keep(std::numeric_limits<double>::max() - x); keep(std::numeric_limits<float>::epsilon()); "
     "keep(std::numeric_limits<double>::quiet_NaN()); keep(std::numbers::pi * x);"},
    {"containers",
     "std::map<int, std::string> m{{i, text}}; m[3] = text; keep(m.size()); std::variant<int, std::string> v = text; "
     "keep(std::get<std::string>(v).size()); std::valarray<double> w(x, 4); keep((std::sin(w) * w).sum()); "
     "keep((*std::make_shared<std::array<double, 3>>())[0]); std::function<double()> f = [=] { return x; }; "
     "keep(f());"},
    {"streams",
     "std::istringstream in(text); double d = 0; in >> d; keep(d); std::ostringstream out; out << d << i << text << "
     "std::hex; "
     "keep(out.str().size()); std::cout << d << std::endl; std::cerr << text;"},
    {"mutex",
     "static std::mutex m; const std::lock_guard lock(m); static std::once_flag once; std::call_once(once, [&] { "
     "keep(x); }); "
     "static thread_local int count = 0; keep(++count);"},
    {"errors",
     "errno = 0; keep(errno); assert(i != -12345); try { if (i == -12345) throw std::out_of_range(text); } catch "
     "(const "
     "std::exception& e) { keep(e.what()[0]); } if (i == -12345) throw \"text\"; if (i == -12345) throw 7;"},
    {"wide_integers",
     "const __int128 w = static_cast<__int128>(i) * i; keep(w / (i | 1) + w % (i | 1)); "
     "keep(static_cast<__float128>(x) * x); "
     "keep(__builtin_powi(x, i)); keep(static_cast<unsigned __int128>(x));"}};

}
