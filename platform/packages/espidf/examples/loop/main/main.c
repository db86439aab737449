#include <stdio.h>

#include "loop.h"

void app_main(void) {
    int born, filled;
    const netmesh_status status = longest_loop(&born, &filled);
    if (status != NETMESH_OK)
        puts(netmesh_status_text(status));
    else
        printf("loop from %d to %d\n", born, filled);
}
