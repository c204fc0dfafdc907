(G96: the spindle turns so that the surface passes at S; feeds per revolution go by it.)
(SOURCE FANUC operator's manuals, constant surface speed control: S m/min about the origin of the work coordinate system)
(SHEET [machine.axes.X])
(SHEET acceleration = 1e9)
(SHEET [machine.axes.Y])
(SHEET acceleration = 1e9)
(SHEET [machine.axes.Z])
(SHEET acceleration = 1e9)

(CASE facing from x 50 to 10: 2 pi/100000 times [50^2-10^2]/2 over .2 minutes are 22.619 s)
(CONTROL fanuc-16i fanuc-30i meldas)
%
O1
G0 X50.
#3001=0
G95 G96 S100 G1 X10. F.2
#100=#3001
M30
%
(EXPECT #100 = 22619 WITHIN 1)

(CASE in two blocks as in one)
(CONTROL fanuc-16i)
%
O1
G0 X50.
#3001=0
G95 G96 S100 G1 X33. F.2
X10.
#100=#3001
M30
%
(EXPECT #100 = 22619 WITHIN 1)

(CASE a quarter of a circle: its mean x is 20+20/pi, its length 5 pi: 7.807 s)
(CONTROL fanuc-16i)
%
O1
G0 X30.
#3001=0
G95 G96 S100 G3 X20. Y10. I-10. F.2
#100=#3001
M30
%
(EXPECT #100 = 7807 WITHIN 1)

(CASE the limit of G92 S: 500 rev/min from x 31.831 on, 50 mm in 33.111 s)
(CONTROL fanuc-16i)
%
O1
G0 X50.
G92 S500
#3001=0
G95 G96 S100 G1 X0. F.2
#100=#3001
M30
%
(EXPECT #100 = 33111 WITHIN 1)

(CASE a thread of 20 mm with a lead of 2 at 600 rev/min: ten turns, a second)
(CONTROL fanuc-16i fanuc-30i meldas)
%
O1
S600 M3
#3001=0
G33 Z-20. F2.
#100=#3001
M30
%
(EXPECT #100 = 1000)
