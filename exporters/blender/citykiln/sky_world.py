"""Sun and sky of a run."""


def set_world(scene, run):
    return []
