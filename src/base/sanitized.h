// Whether this is a build under AddressSanitizer, whose runtime reserves terabytes of addresses and makes pipes to see
// whether memory may be read.
#pragma once

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define UPBEAD_ASAN
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define UPBEAD_ASAN
#endif
