#include <zephyr/sys/printk.h>

#include "loop.h"

int main(void) {
    int born, filled;
    const netmesh_status status = longest_loop(&born, &filled);
    if (status != NETMESH_OK)
        printk("%s\n", netmesh_status_text(status));
    else
        printk("loop from %d to %d\n", born, filled);
    return 0;
}
