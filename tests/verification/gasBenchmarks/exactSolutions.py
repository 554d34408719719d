"""Exact solutions of perfect-gas flow, the references of the benchmarks.

Nondimensional: the gas constant is 1. Angles in radians.
"""
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
FOLDERS = HERE / "reference", HERE.parents[1] / "unit" / "gasDynamics"


def reference(name):
    """A table of values; the first line of its file names the source."""
    file = next(f / name for f in FOLDERS if (f / name).exists())
    return np.genfromtxt(file, delimiter=",", names=True, skip_header=1,
                         dtype=None, encoding="ascii")


class Riemann:
    """source: E. F. Toro, Riemann Solvers and Numerical Methods for Fluid
    Dynamics, 3rd ed., ch. 4. States are (rho, u, p); no vacuum."""

    def __init__(self, left, right, gamma=1.4):
        self.left, self.right, self.gamma = left, right, gamma
        self.p = self.starPressure()
        change = [self.waveFunction(s, self.p)[0] for s in (left, right)]
        self.u = 0.5 * (left[1] + right[1] + change[1] - change[0])

    def waveFunction(self, state, p):
        """Change of velocity across the wave to pressure p; its derivative."""
        rho, _, pk = state
        g = self.gamma
        c = np.sqrt(g * pk / rho)
        if p > pk:
            A, B = 2 / (g + 1) / rho, (g - 1) / (g + 1) * pk
            root = np.sqrt(A / (p + B))
            return (p - pk) * root, root * (1 - (p - pk) / (2 * (p + B)))
        power = (p / pk)**((g - 1) / (2 * g))
        return 2 * c / (g - 1) * (power - 1), power * pk / (p * rho * c)

    def starPressure(self):
        du = self.right[1] - self.left[1]
        p = 0.5 * (self.left[2] + self.right[2])
        for _ in range(200):
            fl, dl = self.waveFunction(self.left, p)
            fr, dr = self.waveFunction(self.right, p)
            new = max(p - (fl + fr + du) / (dl + dr), 1e-3 * p)
            if abs(new - p) < 1e-14 * p:
                return new
            p = new
        raise ArithmeticError("no convergence")

    def sample(self, speed):
        """rho, u, p on the rays x/t = speed."""
        speed = np.asarray(speed, float)
        # The right half is the left half seen from behind
        ahead = self.side(self.left, speed, self.u)
        mirrored = (self.right[0], -self.right[1], self.right[2])
        behind = self.side(mirrored, -speed, -self.u)
        behind[1] *= -1
        return np.where(speed < self.u, ahead, behind)

    def side(self, state, speed, uStar):
        rho, u, p = state
        g, ps = self.gamma, self.p
        c = np.sqrt(g * p / rho)
        outer = np.array([rho, u, p])[:, None]
        if ps > p:
            k = (g - 1) / (g + 1)
            ratio = (ps / p + k) / (k * ps / p + 1)
            inner = np.array([rho * ratio, uStar, ps])
            mach = np.sqrt((g + 1) / (2 * g) * ps / p + (g - 1) / (2 * g))
            shock = u - c * mach
            return np.where(speed < shock, outer, inner[:, None])
        inner = np.array([rho * (ps / p)**(1 / g), uStar, ps])
        tail = uStar - np.sqrt(g * ps / inner[0])
        fan = 2 / (g + 1) * (c + (g - 1) / 2 * u + speed)
        ratio = np.maximum(
            2 / (g + 1) + (g - 1) / (g + 1) / c * (u - speed), 1e-30)
        inside = np.array([
            rho * ratio**(2 / (g - 1)), fan, p * ratio**(2 * g / (g - 1))])
        result = np.where(speed < tail, inside, inner[:, None])
        return np.where(speed < u - c, outer, result)


# Shocks. source: Rankine-Hugoniot conditions (Anderson, Modern Compressible
# Flow, chs. 3, 4 and 7)

def normalShock(mach, gamma=1.4):
    """p2/p1, rho2/rho1, and the speed u2/c1 behind a shock that runs into gas
    at rest."""
    m2, g = np.square(mach), gamma
    p = 1 + 2 * g / (g + 1) * (m2 - 1)
    rho = (g + 1) * m2 / ((g - 1) * m2 + 2)
    return p, rho, mach * (1 - 1 / rho)


def reflectedShock(mach, gamma=1.4):
    """p5/p1, rho5/rho1 at a wall, and the reflected shock's speed over c1."""
    g = gamma
    x, rho2, u2 = normalShock(mach, g)
    p5 = x * ((3 * g - 1) * x - (g - 1)) / ((g - 1) * x + (g + 1))
    y, k = p5 / x, (g - 1) / (g + 1)
    ratio = (y + k) / (k * y + 1)
    return p5, rho2 * ratio, u2 / (ratio - 1)


def deflection(mach, beta, gamma=1.4):
    """Turn of the flow by a shock at the angle beta to it."""
    normal = np.square(mach * np.sin(beta)) - 1
    below = np.square(mach) * (gamma + np.cos(2 * beta)) + 2
    return np.arctan(2 / np.tan(beta) * normal / below)


def bisect(function, low, high):
    sign = np.sign(function(low))
    for _ in range(100):
        middle = 0.5 * (low + high)
        if np.sign(function(middle)) == sign:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def obliqueShock(mach, theta, gamma=1.4):
    """Shock angle, p2/p1, rho2/rho1 and M2 of the weak shock at a wedge."""
    betas = np.linspace(np.arcsin(1 / mach), np.pi / 2, 2000)
    strongest = betas[np.argmax(deflection(mach, betas, gamma))]
    beta = bisect(lambda b: deflection(mach, b, gamma) - theta,
                  np.arcsin(1 / mach), strongest)
    normal = mach * np.sin(beta)
    p, rho, u = normalShock(normal, gamma)
    behind = (normal - u) / np.sqrt(p / rho)
    return beta, p, rho, behind / np.sin(beta - theta)


def prandtlMeyerAngle(mach, gamma=1.4):
    k = np.sqrt((gamma + 1) / (gamma - 1))
    m = np.sqrt(np.square(mach) - 1)
    return k * np.arctan(m / k) - np.arctan(m)


def prandtlMeyer(mach, theta, gamma=1.4):
    """M2, p2/p1 after an expansion round a corner."""
    wanted = prandtlMeyerAngle(mach, gamma) + theta
    m2 = bisect(lambda m: prandtlMeyerAngle(m, gamma) - wanted, mach, 50)
    h = [1 + (gamma - 1) / 2 * m * m for m in (mach, m2)]
    return m2, (h[0] / h[1])**(gamma / (gamma - 1))


def pitotPressure(mach, gamma=1.4):
    """Stagnation pressure behind a normal shock over p1 (Rayleigh)."""
    g, m2 = gamma, mach**2
    return ((g + 1)**2 * m2 / (4 * g * m2 - 2 * (g - 1)))**(g / (g - 1)) \
        * (1 - g + 2 * g * m2) / (g + 1)


def machStem(mach, wedge, gamma=1.4):
    """Angle of the triple point's path to the wedge, and the Mach stem's speed
    along the wedge over c1: three-shock theory with a straight stem
    perpendicular to the wedge.

    source: G. Ben-Dor, Shock Wave Reflection Phenomena, 2nd ed., sec. 1.4
    """
    def mismatch(chi):
        phi = np.pi / 2 - wedge - chi  # incident shock to the flow
        m0 = mach / np.sin(phi)
        p1, theta1, m1 = crossed(m0, phi, gamma)
        stem = np.pi / 2 - chi
        p3, theta3, _ = crossed(m0, stem, gamma)
        # Reflected shock: pressure as behind the stem
        normal = np.sqrt(1 + (gamma + 1) / (2 * gamma) * (p3 / p1 - 1))
        if normal > m1:
            return 1.0
        theta2 = deflection(m1, np.arcsin(normal / m1), gamma)
        return theta1 - theta2 - theta3
    chis = np.radians(np.linspace(1, 30, 600))
    values = np.array([mismatch(chi) for chi in chis])
    i = np.flatnonzero(np.sign(values[1:]) != np.sign(values[:-1]))[0]
    chi = bisect(mismatch, chis[i], chis[i + 1])
    return chi, mach * np.cos(chi) / np.cos(wedge + chi)


def crossed(mach, beta, gamma):
    """p2/p1, deflection and Mach number behind a shock at the angle beta."""
    normal = mach * np.sin(beta)
    p, rho, u = normalShock(normal, gamma)
    theta = deflection(mach, beta, gamma)
    behind = (normal - u) / np.sqrt(p / rho) / np.sin(beta - theta)
    return p, theta, behind


# Pistons

def pushedPiston(speed, gamma=1.4):
    """Shock speed over c0, p2/p0 and rho2/rho0 in front of a piston at
    speed*c0; pulled with speed < 0, then the speed of the fan's tail."""
    g = gamma
    if speed < 0:
        ratio = 1 + (g - 1) / 2 * speed
        return (1 + (g + 1) / 2 * speed, ratio**(2 * g / (g - 1)),
                ratio**(2 / (g - 1)))
    half = speed * (g + 1) / 4
    W = half + np.sqrt(half**2 + 1)
    return W, 1 + g * speed * W, W / (W - speed)


def simpleWave(x, t, k, gamma=1.4):
    """u and c (c0 = 1) at places x in front of a piston with the velocity
    k t^2 and the place k t^3/3, before its waves meet.

    source: each wave carries the piston's velocity V at its start and
    c = 1 + (gamma - 1)/2 V, and runs at V + c (Landau and Lifshitz, Fluid
    Mechanics, par. 101)
    """
    starts = np.linspace(0, t, 4001)
    V = k * starts**2
    c = 1 + (gamma - 1) / 2 * V
    places = k * starts**3 / 3 + (V + c) * (t - starts)
    if (np.diff(places) >= 0).any():
        raise ValueError("the waves have met")
    u = np.interp(x, places[::-1], V[::-1], right=0)
    return u, 1 + (gamma - 1) / 2 * u


# Strong shocks round a centre; directions 1 plane, 2 cylinder, 3 sphere

def noh(r, t, directions, gamma=5 / 3):
    """rho, p, inward speed of cold gas that falls to the centre at speed 1.

    source: W. F. Noh, J. Comput. Phys. 72 (1987) 78-120
    """
    j, g = directions, gamma
    behind = r < (g - 1) / 2 * t
    rho2 = ((g + 1) / (g - 1))**j
    with np.errstate(divide="ignore"):
        ahead = (1 + t / np.asarray(r, float))**(j - 1)
    return (np.where(behind, rho2, ahead),
            np.where(behind, (g - 1) / 2 * rho2, 0.0), np.where(behind, 0, 1))


SEDOV = {1: "planar", 2: "cylindrical", 3: "spherical"}
# source: reference/sedov_constants.csv; plane: for one of the two sides
SEDOV_ALPHA = {1: 0.538742792368, 2: 0.98407401688, 3: 0.851071854758}


class Sedov:
    """Point explosion of energy E (plane: per area and side; cylinder: per
    length) in cold gas of density rho0, gamma 1.4."""

    def __init__(self, energy, t, directions, rho0=1.0):
        j = directions
        self.radius = (energy * t * t / (SEDOV_ALPHA[j] * rho0))**(1 / (j + 2))
        self.speed = 2 / (j + 2) * self.radius / t
        self.rho0, self.j = rho0, j
        self.peak = 5 / 6 * rho0 * self.speed**2

    def sample(self, r):
        """rho, radial velocity, p."""
        profile = reference(f"sedov_profile_gamma1.4_{SEDOV[self.j]}.csv")
        x = r / self.radius
        def at(name, scale, ahead):
            inside = scale * np.interp(
                x, np.r_[0, profile["x"]],
                np.r_[profile[name][0] * (name == "pp2"), profile[name]])
            return np.where(x <= 1, inside, ahead)
        return (at("rhorho2", 6 * self.rho0, self.rho0),
                at("uu2", 5 / 6 * self.speed, 0), at("pp2", self.peak, 0))


# Smooth flow

def vortex(x, t, centre=(5.0, 5.0), velocity=(1.0, 1.0), strength=5.0,
           gamma=1.4):
    """rho, U, p of the isentropic vortex.

    source: C.-W. Shu, NASA/CR-97-206253 (1997), sec. 4.1
    """
    d = x[:, :2] - np.array(centre) - t * np.array(velocity)
    bell = np.exp(0.5 * (1 - (d**2).sum(axis=1)))
    T = 1 - (gamma - 1) * (strength * bell)**2 / (8 * gamma * np.pi**2)
    U = np.zeros((len(x), 3))
    U[:, 0] = velocity[0] - strength / (2 * np.pi) * bell * d[:, 1]
    U[:, 1] = velocity[1] + strength / (2 * np.pi) * bell * d[:, 0]
    rho = T**(1 / (gamma - 1))
    return rho, U, rho * T
