/* The table of options: members of a request by name, for tools and bindings. */
#ifndef NETMESH_OPTIONS_H
#define NETMESH_OPTIONS_H

#include <stdint.h>

#include "context.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum netmesh_option_type {
    NETMESH_OPTION_FLAG = 1, /* uint32_t, 0 or 1; with an object a pointer to it, or null */
    NETMESH_OPTION_UINT32 = 2,
    NETMESH_OPTION_UINT64 = 3,
    NETMESH_OPTION_DOUBLE = 4,
    NETMESH_OPTION_NAME = 5, /* one of its words: uint32_t, or a pointer to an object */
    NETMESH_OPTION_NAMES = 6 /* a union of its words: uint32_t */
} NETMESH_AN_INT netmesh_option_type;

/* A member of netmesh_request that users set by name. Tools make options, help and types of these rows. */
typedef struct netmesh_option {
    uint32_t struct_bytes;
    netmesh_option_type type;
    netmesh_field field;
    uint32_t offset;        /* in netmesh_request */
    const char* name;       /* "focus_ratio" */
    const char* range;      /* "in (0, 1/2]" */
    const char* default_is; /* "1", or what it follows from */
    const char* sentence;   /* what it does, one sentence */
    const void* object;     /* of a FLAG that is a want */
} netmesh_option;

typedef struct netmesh_option_word {
    uint32_t struct_bytes;
    uint32_t value;
    const char* name;
    const void* object; /* in place of the value */
} netmesh_option_word;

/* Row `index`, from 0 on; word `index` of row `option`. INVALID_ARGUMENT: there are no more. The rows name every
 * object: a program that calls these holds the code of all filters, methods and wants. O(1). */
netmesh_status netmesh_get_option(uint32_t index, netmesh_option* option);
netmesh_status netmesh_get_option_word(uint32_t option, uint32_t index, netmesh_option_word* word);

#ifdef __cplusplus
}
#endif
#endif
