// Checks for developers: of what a function requires, and of whole structures after each change. An ordinary build
// holds nothing of them. With cmake -DNETMESH_VALIDATE=ON a check that fails stops the program with its file and line.
#pragma once

#ifdef NETMESH_VALIDATE

// Reports and does not return. The programs that are linked with the engine get it from platform/validate.c.
extern "C" [[noreturn]] void netmesh_validate_failed(const char* file, int line, const char* what);

// Stops unless the condition holds. For what takes constant time.
#define NETMESH_ASSERT(condition)                                                                                      \
    (static_cast<bool>(condition) ? static_cast<void>(0) : netmesh_validate_failed(__FILE__, __LINE__, #condition))

// Stops when the expression, the violation that a checker found as a static text, is not null. For checkers that visit
// a whole structure; each of them limits itself to small ones.
#define NETMESH_VALIDATE_WHOLE(violation)                                                                              \
    do {                                                                                                               \
        if (const char* const found = (violation)) netmesh_validate_failed(__FILE__, __LINE__, found);                 \
    } while (false)

#else

#define NETMESH_ASSERT(condition) static_cast<void>(0)
#define NETMESH_VALIDATE_WHOLE(violation) static_cast<void>(0)

#endif
