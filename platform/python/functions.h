/* All functions by name, for whoever loads the library: the table ends with a null name. */
#ifndef NETMESH_PYTHON_FUNCTIONS_H
#define NETMESH_PYTHON_FUNCTIONS_H

typedef struct netmesh_python_entry {
    const char* name;
    void (*function)(void);
} netmesh_python_entry;

__attribute__((visibility("default"))) extern const netmesh_python_entry netmesh_python_functions[];

#endif
