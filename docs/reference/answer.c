/* Answers the questions about the pull-off force of a paraboloid under a dead load, -(3/2) pi w R, in double precision.
 *
 *     mdr reference --filter "formula=critical control=force quantity=force status=ok" --export records.csv
 *     cc -o answer answer.c -lm
 *     ./answer < records.csv > answers.jsonl
 *     mdr judge answers.jsonl
 *
 * In the table the inputs stand as n=2 C=0.5 E*=1 w=1. The answer is written with %a, which loses nothing; the error it
 * claims is that of a few roundings.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

int main(void)
{
    const double pi = 3.14159265358979323846;
    char line[4096], id[256];
    while (fgets(line, sizeof line, stdin)) {
        double n, c, e, w;
        const char *inputs = strstr(line, "n=");
        if (!inputs || sscanf(inputs, "n=%lf C=%lf E*=%lf w=%lf", &n, &c, &e, &w) != 4 || n != 2)
            continue;
        sscanf(line, "%255[^,]", id);
        const double force = -0.75 * pi * w / c; /* C = 1/2R */
        printf("{\"id\": \"%s\", \"value\": \"%a\", \"error\": %.3g}\n", id, force, 1e-15 * fabs(force));
    }
    return 0;
}
