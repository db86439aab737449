#include <Arduino.h>
#include <netmesh.h>

#include "loop.h"

void setup() { Serial.begin(115200); }

void loop() {
    int born, filled;
    const netmesh_status status = longest_loop(&born, &filled);
    if (status != NETMESH_OK) {
        Serial.println(netmesh_status_text(status));
    } else {
        Serial.print("loop from ");
        Serial.print(born);
        Serial.print(" to ");
        Serial.println(filled);
    }
    delay(1000);
}
