(G93: a block of G01 to G03 takes 1/F minutes.)
(SOURCE FANUC operator's manual B-62764EN/01, 5: F1. ends a block in a minute, F6. in 10 s; on an arc F is the feed over the radius)
(SOURCE Haas mill operator's manual 96-8000, G93: 60 seconds divided by F, whatever axes move)
(SHEET [machine.axes.C])
(SHEET travel = [-3600.0, 3600.0])
(SHEET acceleration = 1e9)
(SHEET [machine.axes.X])
(SHEET acceleration = 1e9)
(SHEET [machine.axes.Y])
(SHEET acceleration = 1e9)

(CASE the manual's 10 s, for linear axes, a rotary one and both)
(CONTROL fanuc-16i fanuc-30i meldas haas brother)
%
O1
G91 G93
#3001=0
G01 X20. Y10. F6.
#100=#3001
G01 X20. C40. F6.
#101=#3001
G01 C-30. F6.
#102=#3001
M30
%
(EXPECT #100 = 10000)
(EXPECT #101 = 20000)
(EXPECT #102 = 30000)

(CASE half a circle: pi over F minutes where F is the feed over the radius)
(CONTROL fanuc-16i meldas)
%
O1
G93
#3001=0
G02 X20. R10. F6.
#100=#3001
M30
%
(EXPECT #100 = 31416 WITHIN 1)

(CASE on a Haas the arc takes 1/F minutes as well)
(CONTROL haas)
%
O1
G93
#3001=0
G02 X20. R10. F6.
#100=#3001
M30
%
(EXPECT #100 = 10000)

(CASE F is of its block alone)
(CONTROL fanuc-30i)
%
O1
G93 G01 X10. F6.
X20.
M30
%
(EXPECT ALARM 1202 AT 5)

(CASE a skip move may be in inverse time, but not on MELDAS)
(CONTROL meldas)
%
O1
G93
G31 X10. F6.
M30
%
(EXPECT ALARM 125 AT 5)
