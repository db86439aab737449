#include <stdio.h>

#include "loop.h"

int main(void) {
    int born, filled;
    const netmesh_status status = longest_loop(&born, &filled);
    if (status != NETMESH_OK) {
        puts(netmesh_status_text(status));
        return 1;
    }
    printf("loop from %d to %d\n", born, filled);
    return 0;
}
