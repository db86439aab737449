// What a run that is to be stopped has to say. For tests of builds with NETMESH_VALIDATE.
#pragma once
#include <doctest/doctest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>

// What a child process that runs this wrote to stderr before it ended by a signal; "lived" if it did not.
template <class Run> std::string last_words(Run&& run) {
    int pipe_ends[2];
    REQUIRE(pipe(pipe_ends) == 0);
    std::fflush(stdout);  // or the child would write it too
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        dup2(pipe_ends[1], 2);
        signal(SIGABRT, SIG_DFL);  // doctest's own handler would report it
        run();
        _exit(0);
    }
    close(pipe_ends[1]);
    std::string words;
    char buffer[256];
    for (ssize_t n; (n = read(pipe_ends[0], buffer, sizeof buffer)) > 0;)
        words.append(buffer, static_cast<std::size_t>(n));
    close(pipe_ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? words : "lived";
}
