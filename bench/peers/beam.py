"""Hexahedral meshes of the cantilever of bench/accuracy.toml, for programs that read a mesh."""
import itertools

LENGTH, WIDTH = 10.0, 2.0  # [m]
YOUNGS_MODULUS, POISSONS_RATIO, DENSITY = 1e5, 0.3, 1000.0  # [Pa], [kg/m^3]
LOAD = -1.0  # [N] along z, spread over the end

# Corners and edge middles of a hexahedron, in units of half its edges: first around its lower face,
# then around its upper one.
CORNERS = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
EDGES = [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
         (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]


class Mesh:
    """Elements of equal size, `across` of them across the beam: an even number, so that the middle of its end is a
    node. Nodes have numbers from 0, and places in units of half an element from the lower corner of the clamp.
    """

    def __init__(self, across, is_quadratic=False):
        shape = CORNERS + (EDGES if is_quadratic else [])
        cells = itertools.product(range(5 * across), range(across), range(across))
        places = [[(2 * i + a, 2 * j + b, 2 * k + c) for a, b, c in shape] for i, j, k in cells]
        self.across = across
        self.spacing = WIDTH / across
        self.numbers = {}
        for place in itertools.chain(*places):
            self.numbers.setdefault(place, len(self.numbers))
        self.elements = [[self.numbers[place] for place in element] for element in places]
        self.loads = self._loads(places)
        self.clamped = [number for place, number in self.numbers.items() if place[0] == 0]
        self.tip = self.numbers[10 * across, across, across]

    def points(self):
        """Places of the nodes [m], by number."""
        half = self.spacing / 2
        return [(x * half, y * half - WIDTH / 2, z * half - WIDTH / 2) for x, y, z in self.numbers]

    def _loads(self, places):
        """Force [N] along z on nodes of the end: consistent with a uniform traction."""
        loads = {}
        for element in places:
            face = [place for place in element if place[0] == 10 * self.across]
            for place in face:
                is_middle = place[1] % 2 + place[2] % 2 == 1
                weight = 1 / 4 if len(face) == 4 else 1 / 3 if is_middle else -1 / 12
                number = self.numbers[place]
                loads[number] = loads.get(number, 0) + weight * LOAD / self.across**2
        return loads
