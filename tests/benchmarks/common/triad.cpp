// Memory bandwidth of one core: a = b + s c over arrays far larger than the
// caches, the triad of J. D. McCalpin's STREAM. Prints GB/s: the best of ten
// passes, counting the three arrays once each.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <vector>

int main()
{
    const std::size_t n = 20000000;
    std::vector<double> a(n, 0), b(n, 1), c(n, 2);
    double best = 0;
    for (int pass = 1; pass <= 10; ++pass)
    {
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < n; ++i)
        {
            a[i] = b[i] + pass*c[i];
        }
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        best = std::max(best, 3*n*sizeof(double)/taken.count()/1e9);
    }
    // The sum is used, so that no pass can be left out
    std::printf("%.2f %g\n", best, a[n/2]);
}
