"""Draws one structure with several tools, right and wrong: python3 make.py FOLDER [PART ...]"""
import json
import math
import os
import subprocess
import sys

OUT = sys.argv[1]
HERE = os.path.dirname(os.path.abspath(__file__))
os.makedirs(OUT, exist_ok=True)

# Points, edges, faces (counter-clockwise, y up), the edge that is changed.
S = json.load(open(os.environ.get("STRUCTURE", os.path.join(HERE, "drawing.json"))))
V = [tuple(p) for p in S["vertices"]]
E = [tuple(e) for e in S["edges"]]
F = [list(f) for f in S["faces"]]
MAST = next(i for i, (a, b) in enumerate(E) if {V[a], V[b]} == {tuple(p) for p in S["mast"]})

def right(): return [list(p) for p in V], list(E), [list(f) for f in F]
def no_edge():
    v, e, f = right(); del e[MAST]; return v, e, f
def moved():
    v, e, f = right(); v[V.index(tuple(S["mast"][1]))][0] += 4; return v, e, f
def extra():
    v, e, f = right(); e.append(tuple(V.index(tuple(p)) for p in S["extra"])); return v, e, f
def mirrored():
    v, e, f = right(); return [[-x, y] for x, y in v], e, [g[::-1] for g in f]
def turned(deg=25):
    v, e, f = right(); s, c = math.sin(math.radians(deg)), math.cos(math.radians(deg))
    return [[c*x - s*y, s*x + c*y] for x, y in v], e, f
def stretched():
    v, e, f = right(); return [[x, 1.4*y] for x, y in v], e, f

made = []
def done(name, ok): made.append((name, ok))
def write(name, text, ok):
    open(os.path.join(OUT, name), "w").write(text); done(name, ok)

TINTS = ["#cfe3f7", "#f7e3cf", "#d5f0d0", "#f0d0e6", "#fff3b0"]

def mpl():
    import matplotlib; matplotlib.use("svg")
    import matplotlib.pyplot as plt
    from matplotlib.patches import Polygon
    from matplotlib.collections import LineCollection, PolyCollection
    plt.rcParams["svg.hashsalt"] = "x"
    def fig(name, shape, ok, axes=False, how="plot", order=(1, 2, 3), legend=False, title=False, faces="patch", ms=5, lw=1.5, color="k", labels=False, bbox=False, equal=True, close=False, fonttype="path", dots="plot", markers="o", grid=False, facecolor=None, dotcolor=None, transparent=False, alpha=1, hatch=None):
        plt.rcParams["svg.fonttype"] = fonttype
        v, e, f = shape
        fg, ax = plt.subplots(figsize=(6, 4))
        if facecolor: fg.set_facecolor(facecolor); ax.set_facecolor(facecolor)
        if equal: ax.set_aspect("equal")
        if not axes: ax.axis("off")
        if faces == "patch":
            for i, g in enumerate(f): ax.add_patch(Polygon([v[k] for k in g], closed=True, facecolor="none" if hatch else TINTS[i % 5], edgecolor="none", hatch=hatch, zorder=order[0], alpha=alpha))
        elif faces == "coll":
            ax.add_collection(PolyCollection([[v[k] for k in g] for g in f], facecolors=TINTS, zorder=order[0]))
        elif faces == "fill":
            for i, g in enumerate(f): ax.fill([v[k][0] for k in g], [v[k][1] for k in g], color=TINTS[i % 5], lw=0, zorder=order[0])
        elif faces == "edge":
            for i, g in enumerate(f): ax.add_patch(Polygon([v[k] for k in g], closed=True, facecolor=TINTS[i % 5], edgecolor="k", zorder=order[0]))
        if how == "plot":
            for a, b in e: ax.plot([v[a][0], v[b][0]], [v[a][1], v[b][1]], color=color, lw=lw, zorder=order[1], label="edges" if (a, b) == e[0] else None)
        elif how == "coll":
            ax.add_collection(LineCollection([[v[a], v[b]] for a, b in e], colors=color, linewidths=lw, zorder=order[1]))
        elif how == "nan":
            xs, ys = [], []
            for a, b in e: xs += [v[a][0], v[b][0], float("nan")]; ys += [v[a][1], v[b][1], float("nan")]
            ax.plot(xs, ys, color=color, lw=lw, zorder=order[1])
        if dots == "plot": ax.plot([p[0] for p in v], [p[1] for p in v], markers, color=dotcolor or "k", ms=ms, zorder=order[2], label="vertices")
        elif dots == "scatter": ax.scatter([p[0] for p in v], [p[1] for p in v], s=ms*ms, color=dotcolor or "k", zorder=order[2])
        if labels:
            for i, p in enumerate(v): ax.annotate(f"v{i}", p, textcoords="offset points", xytext=(5, 4), fontsize=7, bbox=dict(boxstyle="round", fc="white", ec="0.5") if bbox else None)
        if legend == "inside": ax.legend(loc="upper right", fontsize=6)
        elif legend == "over": ax.legend(loc="center", fontsize=20, framealpha=1).set_zorder(9)
        elif legend: ax.legend(loc="center left", bbox_to_anchor=(1.02, 0.5))
        if title: ax.set_title("A ship")
        if grid: ax.grid(True)
        ax.autoscale_view()
        fg.savefig(os.path.join(OUT, name), transparent=transparent); plt.close(fg); done(name, ok)
    fig("matplotlib-plain.svg", right(), 1)
    fig("matplotlib-axes.svg", right(), 1, axes=True)
    fig("matplotlib-axes-legend-title.svg", right(), 1, axes=True, legend=True, title=True)
    fig("matplotlib-legend.svg", right(), 1, legend=True)
    fig("matplotlib-collections.svg", right(), 1, how="coll", faces="coll", dots="scatter")
    fig("matplotlib-one-path.svg", right(), 1, how="nan", faces="fill")
    fig("matplotlib-labels.svg", right(), 1, labels=True)
    fig("matplotlib-labels-as-text.svg", right(), 1, labels=True, fonttype="none")
    fig("matplotlib-polygons-with-edges.svg", right(), 1, faces="edge", how="none")
    fig("matplotlib-dark.svg", right(), 1, facecolor="#202020", color="w", dotcolor="w")
    fig("matplotlib-transparent.svg", right(), 1, transparent=True)
    fig("matplotlib-translucent-over-lines.svg", right(), 1, order=(3, 1, 4), alpha=0.4)
    fig("matplotlib-edge-missing.svg", no_edge(), 0)
    fig("matplotlib-vertex-moved.svg", moved(), 0, axes=True)
    fig("matplotlib-extra-edge.svg", extra(), 0, how="coll", faces="coll", dots="scatter")
    fig("matplotlib-faces-over-lines.svg", right(), 0, order=(3, 1, 4))
    fig("matplotlib-white-lines.svg", right(), 0, color="w", faces="none")
    fig("matplotlib-mirrored.svg", mirrored(), 0, axes=True)
    fig("matplotlib-turned.svg", turned(), 0)
    fig("matplotlib-unequal-axes.svg", right(), 0, equal=False, axes=True)
    fig("matplotlib-big-markers.svg", right(), 0, ms=S.get("big", 60))
    fig("matplotlib-no-markers.svg", right(), 0, dots="none")
    fig("matplotlib-legend-inside.svg", right(), 1, legend="inside", fonttype="none")
    fig("matplotlib-legend-inside-edge-missing.svg", no_edge(), 0, legend="inside", fonttype="none")
    fig("matplotlib-legend-over-lines.svg", right(), 0, legend="over", fonttype="none")
    fig("matplotlib-hatched.svg", right(), 1, hatch="//")
    fig("matplotlib-hatched-edge-missing.svg", no_edge(), 0, hatch="//")
    for name, marker in [("squares", "s"), ("crosses", "x"), ("pluses", "+")]:
        fig(f"matplotlib-{name}.svg", right(), 1, markers=marker)
    fig("matplotlib-squares-edge-missing.svg", no_edge(), 0, markers="s")
    fig("matplotlib-crosses-vertex-moved.svg", moved(), 0, markers="x")

def canvas(p, k=1.0): return (300 + k * p[0], 200 - k * p[1])

def svgw():
    import svgwrite
    def fig(name, shape, ok, how="line", unit=None, css=False, group=False, hide=None, symbol=False, viewbox=True, r=4, faces=True):
        v, e, f = shape; P = [canvas(p) for p in v]
        size = ("600px", "400px") if unit is None else ("158.75mm", "105.833mm")
        d = svgwrite.Drawing(os.path.join(OUT, name), size=size, profile="full", debug=False)
        if viewbox: d.viewbox(0, 0, 600, 400)
        d.add(d.rect((0, 0), ("100%", "100%"), fill="white"))
        if css: d.defs.add(d.style(".e{stroke:navy;stroke-width:2;fill:none} .n{fill:crimson} .c{fill:#eef}"))
        root = d.add(d.g(transform="translate(300,200) scale(1,-1)")) if group else d
        Q = v if group else P
        if faces:
            for i, g in enumerate(f):
                poly = d.polygon([Q[k] for k in g]); root.add(poly)
                if css: poly["class"] = "c"
                else: poly["fill"] = TINTS[i % 5]
        U = lambda p: p
        if unit == "mm": U = lambda p: tuple(f"{c * 25.4 / 96:.6f}mm" for c in p)
        if how == "line":
            for j, (a, b) in enumerate(e):
                l = d.line(U(Q[a]), U(Q[b])); root.add(l)
                if css: l["class"] = "e"
                else: l["stroke"] = "black"
                if hide == "dash" and j == MAST: l["stroke-dasharray"] = "0,1000"
                if hide == "opacity" and j == MAST: l["opacity"] = "0.01"
        elif how == "polyline":
            for a, b in e: root.add(d.polyline([Q[a], Q[b]], stroke="black", fill="none"))
        elif how == "path":
            root.add(d.path(d=" ".join(f"M{Q[a][0]},{Q[a][1]} L{Q[b][0]},{Q[b][1]}" for a, b in e), stroke="black", fill="none"))
        elif how == "cut":
            # long straight stretches in one line, where edges go straight on
            for a, b in e: root.add(d.path(d=f"m{Q[a][0]},{Q[a][1]} {Q[b][0]-Q[a][0]},{Q[b][1]-Q[a][1]} {Q[a][0]-Q[b][0]},{Q[a][1]-Q[b][1]}", stroke="black", fill="none"))
        elif how == "bars":
            for a, b in e:
                (x, y), (z, w) = Q[a], Q[b]; L = math.hypot(z-x, w-y); nx, ny = -(w-y)/L, (z-x)/L
                root.add(d.polygon([(x+nx, y+ny), (z+nx, w+ny), (z-nx, w-ny), (x-nx, y-ny)], fill="black"))
        if symbol:
            s = d.symbol(id="dot"); s.viewbox(-5, -5, 10, 10); s.add(d.circle((0, 0), 5, fill="crimson")); d.defs.add(s)
            for p in Q: root.add(d.use("#dot", insert=(p[0]-4, p[1]-4), size=(8, 8)))
        else:
            for p in Q:
                c = d.circle(U(p), r); root.add(c)
                if css: c["class"] = "n"
        if hide == "box": d.add(d.rect((240, 130), (110, 180), fill="white"))
        if hide == "label":
            m = [(P[E[MAST][0]][i] + P[E[MAST][1]][i]) / 2 for i in (0, 1)]
            d.add(d.rect((m[0]-9, m[1]-7), (18, 14), fill="white")); d.add(d.text("e", insert=(m[0]-4, m[1]+4)))
        if hide == "clip":
            c = d.clipPath(id="c"); c.add(d.rect((0, 0), (600, (P[E[MAST][0]][1] + P[E[MAST][1]][1]) / 2))); d.defs.add(c)
            l = d.line(P[E[MAST][0]], P[E[MAST][1]], stroke="black", clip_path="url(#c)")
            root.elements = [x for x in root.elements if not (x.elementname == "line" and x["x1"] == P[E[MAST][0]][0] and x["y1"] == P[E[MAST][0]][1] and x["x2"] == P[E[MAST][1]][0] and x["y2"] == P[E[MAST][1]][1])] + [l]
        d.save(); done(name, ok)
    fig("svgwrite-plain.svg", right(), 1)
    fig("svgwrite-css.svg", right(), 1, css=True)
    fig("svgwrite-group-flipped.svg", right(), 1, group=True)
    fig("svgwrite-polylines.svg", right(), 1, how="polyline")
    fig("svgwrite-one-path.svg", right(), 1, how="path")
    fig("svgwrite-there-and-back.svg", right(), 1, how="cut")
    fig("svgwrite-bars.svg", right(), 1, how="bars")
    fig("svgwrite-symbols.svg", right(), 1, symbol=True)
    fig("svgwrite-label-on-edge.svg", right(), 1, hide="label")
    fig("svgwrite-mm.svg", right(), 1, unit="mm-view")
    fig("svgwrite-edge-missing.svg", no_edge(), 0, how="path")
    fig("svgwrite-bar-missing.svg", no_edge(), 0, how="bars")
    fig("svgwrite-vertex-moved.svg", moved(), 0, css=True)
    fig("svgwrite-box-over-lines.svg", right(), 0, hide="box")
    fig("svgwrite-empty-dashes.svg", right(), 0, hide="dash")
    fig("svgwrite-faint-line.svg", right(), 0, hide="opacity")
    fig("svgwrite-clipped-line.svg", right(), 0, hide="clip")
    fig("svgwrite-huge-circles.svg", right(), 0, r=110)
    fig("svgwrite-stretched.svg", stretched(), 0)

def drawsvg_():
    import drawsvg as draw
    def fig(name, shape, ok, origin="center", arrows=False, use=False, nested=False, faces_last=False):
        v, e, f = shape
        d = draw.Drawing(620, 420, origin=origin)
        d.append(draw.Rectangle(-310, -210, 620, 420, fill="#fdfdf5"))
        def faces():
            for i, g in enumerate(f):
                pts = [c for k in g for c in (v[k][0], -v[k][1])]
                target.append(draw.Lines(*pts, close=True, fill=TINTS[i % 5]))
        target = d
        if nested:
            target = draw.Group(transform="scale(0.8) rotate(0)"); d.append(target)
        if not faces_last: faces()
        kw = {}
        if arrows:
            m = draw.Marker(-0.1, -0.5, 0.9, 0.5, scale=4, orient="auto"); m.append(draw.Lines(-0.1, 0.5, -0.1, -0.5, 0.9, 0, fill="red", close=True)); kw = dict(marker_end=m)
        for a, b in e: target.append(draw.Line(v[a][0], -v[a][1], v[b][0], -v[b][1], stroke="#333", stroke_width=2, **kw))
        dot = draw.Circle(0, 0, 5, fill="purple")
        for p in v: target.append(draw.Use(dot, p[0], -p[1]) if use else draw.Circle(p[0], -p[1], 5, fill="purple"))
        if faces_last: faces()
        d.save_svg(os.path.join(OUT, name)); done(name, ok)
    fig("drawsvg-plain.svg", right(), 1)
    fig("drawsvg-use.svg", right(), 1, use=True)
    fig("drawsvg-arrow-markers.svg", right(), 1, arrows=True)
    fig("drawsvg-nested-group.svg", right(), 1, nested=True)
    fig("drawsvg-edge-missing.svg", no_edge(), 0, use=True)
    fig("drawsvg-vertex-moved.svg", moved(), 0)
    fig("drawsvg-faces-last.svg", right(), 0, faces_last=True)
    fig("drawsvg-turned.svg", turned(-40), 0)

def cairo_():
    try: import cairo
    except ImportError: import cairocffi as cairo
    def fig(name, shape, ok, hollow=False, bg=True, cover=False):
        v, e, f = shape
        s = cairo.SVGSurface(os.path.join(OUT, name), 600, 400); c = cairo.Context(s)
        if bg: c.set_source_rgb(1, 1, 1); c.paint()
        c.translate(300, 200); c.scale(1, -1)
        for i, g in enumerate(f):
            t = TINTS[i % 5]; c.set_source_rgb(*[int(t[j:j+2], 16) / 255 for j in (1, 3, 5)])
            c.move_to(*v[g[0]])
            for k in g[1:]: c.line_to(*v[k])
            c.close_path(); c.fill()
        c.set_source_rgb(0, 0, 0); c.set_line_width(1.5)
        for a, b in e: c.move_to(*v[a]); c.line_to(*v[b]); c.stroke()
        for p in v:
            c.arc(p[0], p[1], 4, 0, 2 * math.pi)
            if hollow: c.set_source_rgb(1, 1, 1); c.fill_preserve(); c.set_source_rgb(0, 0, 0); c.stroke()
            else: c.fill()
        if cover: c.set_source_rgb(1, 1, 1); c.rectangle(-40, -60, 80, 80); c.fill()
        s.finish(); done(name, ok)
    fig("cairo-plain.svg", right(), 1)
    fig("cairo-hollow.svg", right(), 1, hollow=True, bg=False)
    fig("cairo-edge-missing.svg", no_edge(), 0)
    fig("cairo-vertex-moved.svg", moved(), 0, hollow=True)
    fig("cairo-covered.svg", right(), 0, cover=True)


def run(*args): subprocess.run(args, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=OUT, timeout=120)

def tikz():
    def tex(name, shape, opts="", edges=None, faces_last=False, labels=False, white=False, circle="fill"):
        v, e, f = shape; k = 0.02
        lines = [r"\documentclass{article}\usepackage{tikz}", r"\pagestyle{empty}\begin{document}\begin{tikzpicture}[%s]" % opts]
        cs = [f"({p[0]*k:.5f},{p[1]*k:.5f})" for p in v]
        fl = []
        for i, g in enumerate(f):
            fl.append(r"\fill[%s!20] %s -- cycle;" % (["blue", "orange", "green", "red", "yellow"][i % 5], " -- ".join(cs[j] for j in g)))
        if not faces_last: lines += fl
        for j, (a, b) in enumerate(e):
            lab = r" node[midway,fill=white,inner sep=1pt,font=\tiny] {$e_{%d}$}" % j if labels and j % 4 == 0 else ""
            lines.append(r"\draw%s %s -- %s%s;" % ("[white]" if white and j == MAST else "", cs[a], cs[b], lab))
        if faces_last: lines += fl
        for c in cs: lines.append((r"\fill %s circle (2pt);" if circle == "fill" else r"\filldraw[fill=white] %s circle (2pt);") % c)
        lines.append(r"\end{tikzpicture}\end{document}")
        open(os.path.join(OUT, name + ".tex"), "w").write("\n".join(lines))
        run("pdflatex", "-interaction=batchmode", name + ".tex")
    def dvi(name, ok): run("dvisvgm", "--pdf", "--no-fonts", name + ".pdf", "-o", "tikz-dvisvgm-" + name[5:] + ".svg"); done("tikz-dvisvgm-" + name[5:] + ".svg", ok)
    def pdf(name, ok): run("pdf2svg", name + ".pdf", "tikz-pdf2svg-" + name[5:] + ".svg"); done("tikz-pdf2svg-" + name[5:] + ".svg", ok)
    def both(name, ok):
        for f in (dvi, pdf):
            try: f(name, ok)
            except Exception as x: print("failed", name, f.__name__, x)
    tex("tikz-plain", right()); both("tikz-plain", 1)
    tex("tikz-hollow", right(), circle="hollow"); both("tikz-hollow", 1)
    tex("tikz-labels", right(), labels=True); both("tikz-labels", 1)
    tex("tikz-edge-missing", no_edge()); both("tikz-edge-missing", 0)
    tex("tikz-vertex-moved", moved()); both("tikz-vertex-moved", 0)
    tex("tikz-faces-last", right(), faces_last=True); both("tikz-faces-last", 0)
    tex("tikz-white-edge-on-tinted-faces", right(), white=True); both("tikz-white-edge-on-tinted-faces", 0)

def inkscape():
    def act(name, source, actions, ok):
        run("inkscape", source, "--actions=" + actions + f";export-filename:{name};export-do")
        done(name, ok)
    act("inkscape-resaved.svg", "svgwrite-plain.svg", "export-plain-svg", 1)
    run("inkscape", "svgwrite-plain.svg", "--export-plain-svg", "--export-filename=inkscape-plain.svg"); done("inkscape-plain.svg", 1)
    act("inkscape-object-to-path.svg", "svgwrite-plain.svg", "select-all:all;object-to-path", 1)
    act("inkscape-lines-stroke-to-path.svg", "svgwrite-plain.svg", "select-by-element:line;object-stroke-to-path", 1)
    act("inkscape-grouped.svg", "svgwrite-plain.svg", "select-all:all;selection-group;transform-scale:0.8;transform-translate:10,20", 1)
    act("inkscape-combined.svg", "svgwrite-polylines.svg", "select-by-element:polyline;path-combine", 1)
    act("inkscape-circles-to-path.svg", "svgwrite-plain.svg", "select-by-element:circle;object-to-path", 1)
    act("inkscape-edge-missing-to-path.svg", "svgwrite-edge-missing.svg", "select-all:all;object-to-path", 0)
    act("inkscape-stroke-to-path-edge-missing.svg", "drawsvg-edge-missing.svg", "select-by-element:line;object-stroke-to-path", 0)
    act("inkscape-rotated.svg", "svgwrite-plain.svg", "select-all:all;transform-rotate:15", 0)
    act("inkscape-polygons-raised.svg", "svgwrite-plain.svg", "select-by-element:polygon;selection-top", 0)
    act("inkscape-polygons-lowered.svg", "svgwrite-plain.svg", "select-by-element:polygon;selection-bottom;select-clear;select-by-element:rect;selection-bottom", 1)
    act("inkscape-flipped.svg", "svgwrite-plain.svg", "select-all:all;selection-group;object-flip-horizontal", 0)

def rsvg():
    for name, ok in [("svgwrite-plain", 1), ("svgwrite-css", 1), ("svgwrite-edge-missing", 0), ("svgwrite-box-over-lines", 0), ("matplotlib-axes", 1)]:
        out = "rsvg-" + name.split("-", 1)[1] + ("-of-matplotlib" if name.startswith("matplotlib") else "") + ".svg"
        run("rsvg-convert", "-f", "svg", "-o", out, name + ".svg"); done(out, ok)
    import cairosvg
    for name, ok in [("svgwrite-group-flipped", 1), ("svgwrite-symbols", 1), ("svgwrite-vertex-moved", 0)]:
        out = "cairosvg-" + name.split("-", 1)[1] + ".svg"
        cairosvg.svg2svg(url=os.path.join(OUT, name + ".svg"), write_to=os.path.join(OUT, out)); done(out, ok)

PARTS = [mpl, svgw, drawsvg_, cairo_, tikz, inkscape, rsvg]
if len(sys.argv) > 2: PARTS = [p for p in PARTS if p.__name__ in sys.argv[2:]]
for part in PARTS:
    try: part()
    except Exception as x:
        import traceback; traceback.print_exc()
with open(os.path.join(OUT, "verdicts.txt"), "w" if len(sys.argv) < 3 else "a") as out:
    for name, ok in made: out.write(f"{'equal' if ok else 'different'} {name}\n")
print(len(made))
